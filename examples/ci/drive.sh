#!/usr/bin/env bash
# drive.sh: a dialogue with a simulated drive by can-utils, on a bus of its own: with-can --private -- ./drive.sh
set -euo pipefail

work=$(mktemp -d)
trap 'kill $(jobs -p); wait; rm -rf "$work"' EXIT
touch "$work/axisd"
candump -L vcan0 >"$work/log" &
axisd --interface "unix:$CAN_BUS" --node-id 5 --control none --state-directory "$work" 2>"$work/axisd" &

# expect FRAME: waits up to ten seconds until candump has seen it.
expect() {
  for ((tries = 0; tries < 200; ++tries)); do
    ! grep -q " $1$" "$work/log" || return 0
    sleep 0.05
  done
  echo "no $1 in:" >&2
  cat "$work/log" "$work/axisd" >&2
  exit 1
}

until grep -q ready "$work/axisd"; do sleep 0.05; done
until cansend vcan0 7FF# && grep -q 7FF "$work/log"; do sleep 0.05; done # candump listens, too
cansend vcan0 605#4000100000000000 # SDO: read 1000h
expect 585#430010009201FFFF
cansend vcan0 000#0105 # NMT: start node 5
expect 185#4016
cansend vcan0 205#0600 # shutdown
expect 185#3116
echo "the drive is ready to switch on"
