#!/usr/bin/env bash
# sim.sh [--seeds N] [--first N] [--jobs N] [--shrink]: runs the worlds of N seeds (1000), from seed 1 or another one on.
#
# Builds axisd-sim (build/release) and divides the seeds among N processes (all processors). A world in which an invariant
# does not hold is printed with its last frames and the command that has it again; --shrink looks for a smaller one, too. Ends
# with the sums of all, which are in build/sim/PART.json as well; the exit status is 1 if any invariant was broken.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

seeds=1000 first=1 options=()
while (($#)); do
  case $1 in
    --seeds) need_number "$@"; seeds=$2; shift ;;
    --first) need_number "$@"; first=$2; shift ;;
    --jobs) need_number "$@"; jobs=$2; shift ;;
    --shrink) options+=(--shrink) ;;
    *) misuse "unknown option $1; usage: sim.sh [--seeds N] [--first N] [--jobs N] [--shrink]" ;;
  esac
  shift
done

build release axisd-sim
folder=$root/build/sim
mkdir -p "$folder"
rm -f "$folder"/*.json
((jobs <= seeds)) || jobs=$seeds
say "running $seeds worlds in $jobs processes"
pids=() status=0
for ((job = 0; job < jobs; ++job)); do
  begin=$((first + seeds * job / jobs)) end=$((first + seeds * (job + 1) / jobs))
  "$root/build/release/bin/axisd-sim" --first "$begin" --seeds $((end - begin)) --json "$folder/$job.json" "${options[@]}" &
  pids+=($!)
done
trap 'kill "${pids[@]}" 2>/dev/null' INT TERM
for pid in "${pids[@]}"; do wait "$pid" || status=1; done
python3 - "$folder"/*.json <<'EOF'
import json, sys
parts = [json.load(open(name)) for name in sys.argv[1:]]
print(', '.join(f'{key} {sum(part[key] for part in parts):.0f}' for key in parts[0]))
EOF
exit "$status"
