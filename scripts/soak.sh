#!/usr/bin/env bash
# soak.sh HOURS [--seed N]: daemon, hub, gateway, masters and faults for so long (0.5: half an hour), on the user-space bus and,
# beside it, on vcan0 (where the kernel has none: in the virtual machine of vcan-vm). tests/bus_e2e/soak.py says what is done and
# what must not happen. What was measured is in build/soak/*.json; the exit status is 1 if anything failed.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

[[ ${1:-} =~ ^[0-9]+(\.[0-9]+)?$ ]] || misuse "expected a number of hours; usage: soak.sh HOURS [--seed N]"
seconds=$(awk "BEGIN {printf \"%d\", $1 * 3600}")
shift
seed=()
while (($#)); do
  case $1 in
    --seed) need_number "$@"; seed=(--seed "$2"); shift ;;
    *) misuse "unknown option $1; usage: soak.sh HOURS [--seed N]" ;;
  esac
  shift
done

build release axisd axisd-http canhub with-can can-preload
folder=$root/build/soak bin=$root/build/release/bin
mkdir -p "$folder"
rm -f "$folder"/*.json
soak=("$root/tests/bus_e2e/soak.py" "$bin" --seconds "$seconds" "${seed[@]}")
export PYTHONDONTWRITEBYTECODE=1
say "$seconds s on the user-space bus, and on vcan0"
"$root/tests/bus_e2e/own_network.sh" "$bin/with-can" --private -- python3 "${soak[@]}" --json "$folder/user.json" >"$folder/user" 2>&1 &
user=$!
trap 'kill "$user" 2>/dev/null' INT TERM
status=0
if [[ -e /sys/class/net/vcan0 ]]; then
  python3 "${soak[@]}" --interface vcan0 --json "$folder/kernel.json" >"$folder/kernel" 2>&1 || status=1
else
  "$root/scripts/vcan-vm" --mem 2048 --timeout $((seconds + 300)) --out "$folder" -- \
    python3 "${soak[@]}" --interface vcan0 --json "$folder/kernel.json" >"$folder/kernel" 2>&1 || status=1
fi
wait "$user" || status=1
for bus in user kernel; do
  say "$bus"
  cat "$folder/$bus"
done
exit "$status"
