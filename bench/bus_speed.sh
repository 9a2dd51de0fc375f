#!/usr/bin/env bash
# bus_speed.sh [--build DIR]: what a CAN bus of this machine carries, as Markdown: round trips between two programs, and
# frames a second from one to 1 and to 99 others.
#
# The user-space bus is measured here and, beside vcan, in the virtual machine of scripts/vcan-vm, whose processor is
# emulated: compare its two rows with each other. vcan is measured here too where this kernel has it.
#
# --build   the build with the programs (build/release, built first if it is this one)
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/../scripts/common.sh"
cd "$root"

build=build/release inside=''
while (($#)); do
  case $1 in
    --build) build=${2:-}; [[ $build ]] || misuse "--build needs a folder"; shift 2 ;;
    --inside) inside=yes; shift ;;
    *) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2 ;;
  esac
done

readonly bursts=200 round_trips=10000
bus_speed=$build/bin/bus_speed with_can=("$build/bin/with-can" --private --)

# row NAME COMMAND...: a line of the table from a run with 2 and one with 100 members.
row() {
  local name=$1
  shift
  {
    "$@" "$bus_speed" vcan0 2 "$bursts" "$round_trips"
    "$@" "$bus_speed" vcan0 100 $((bursts / 10)) 100 | sed '/^round/d;s/^/many_/'
  } | awk -v name="$name" '
    { figure[$1] = $2 }
    END {
      printf "| %s | %.1f | %.1f | %d | %d | %d | %d |\n", name, figure["round_trip_p50_ns"] / 1000,
        figure["round_trip_p99_ns"] / 1000, figure["frames_a_second"], figure["many_frames_a_second"],
        figure["many_deliveries_a_second"], figure["lost"] + figure["many_lost"]
    }'
}

if [[ $inside ]]; then
  row 'vcan, virtual machine' env
  row 'user-space bus, virtual machine' "${with_can[@]}"
  exit
fi

[[ $build != build/release ]] || build release bus_speed with-can canhub can-preload >&2
echo '| bus | round trip p50 (us) | p99 (us) | frames/s, 2 members | frames/s, 100 members | deliveries/s, 100 members | lost |'
echo '|---|---:|---:|---:|---:|---:|---:|'
row 'user-space bus' "${with_can[@]}"
if have_can; then row vcan env; fi
scripts/vcan-vm --timeout 600 -- bench/bus_speed.sh --inside --build "$build"
