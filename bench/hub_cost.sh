#!/usr/bin/env bash
# hub_cost.sh [--build DIR] [--slices N] [--hub PROGRAM]: what the hub of a user-space bus costs, as Markdown: a frame that all
# members hear, bursts, and a frame that all but one filter out.
#
# Beside it, in turns and in the same run, the floor: a program that reads a message from one socket and writes it to all others. Processor
# time is that of who hands the frame on alone; the other time is until the last member has it. Ratios are medians over slices, so
# that what else the machine does counts for both. Then the instructions of the hub in user space, from callgrind.
#
# --build   the build with the programs (build/release, built first if it is this one)
# --slices  of each row (101)
# --hub     another canhub than that of the build
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/../scripts/common.sh"
cd "$root"

build=build/release slices=101 hub=''
while (($#)); do
  case $1 in
    --build) build=${2:-}; [[ $build ]] || misuse "--build needs a folder"; shift 2 ;;
    --slices) need_number "$@"; slices=$2; shift 2 ;;
    --hub) hub=${2:-}; [[ $hub ]] || misuse "--hub needs a program"; shift 2 ;;
    *) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2 ;;
  esac
done

[[ $build != build/release ]] || build release hub_cost canhub instruction_count >&2
"$build/bin/hub_cost" "${hub:-$build/bin/canhub}" "$slices"
echo
bench/callgrind.sh --build "$build" --times 2000 hub/all_2 hub/all_8 hub/all_32 hub/all_127 hub/burst_127 hub/one_127
