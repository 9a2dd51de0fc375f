#!/usr/bin/env bash
# flood.sh [--build DIR] [--runs N] [--frames N]: RPDOs back to back, without a pause and for longer than any receive buffer lasts, to a
# unit whose eight axes turn and which may do nothing that needs a capability, as the installed service: how many it took.
#
# In the virtual machine on vcan0, and on a user-space bus of this machine. The receive buffer is what net.core.rmem_max leaves
# to everybody (Linux: 212,992 bytes, some hundred frames). Before a flood come a few bursts that this buffer holds: the virtual machine
# translates what it runs for the first time, which takes longer than the buffer lasts; no processor does that.
#
# --build   the build with the programs (build/release, built first if it is this one)
# --runs    on each bus (3)
# --frames  of each run (50000)
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/../scripts/common.sh"
cd "$root"

build=build/release runs=3 frames=50000 inside=''
while (($#)); do
  case $1 in
    --build) build=${2:-}; [[ $build ]] || misuse "--build needs a folder"; shift 2 ;;
    --runs) need_number "$@"; runs=$2; shift 2 ;;
    --frames) need_number "$@"; frames=$2; shift 2 ;;
    --inside) inside=yes; shift ;;
    *) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2 ;;
  esac
done

programs=(axisd axisctl bus_client canhub with-can)
if [[ ! $inside ]]; then
  [[ $build != build/release ]] || build release "${programs[@]}" can-preload >&2
  words=(bench/flood.sh --inside --build "$build" --runs "$runs" --frames "$frames")
  echo "| bus | receive buffer (bytes) | frames sent | taken | lost | skipped cycles |"
  echo "|---|---:|---:|---:|---:|---:|"
  "$build/bin/with-can" --private -- "${words[@]}"
  exec scripts/vcan-vm -- "${words[@]}"
fi

readonly node=1 axes=8
readonly axis_objects=0x800 sdo=601
# What the service has of root's: nothing.
readonly as_service=(setpriv --bounding-set=-all --inh-caps=-all)
bin=$build/bin
interface=vcan0 bus=SocketCAN
[[ ! ${CAN_BUS:-} ]] || interface=unix:$CAN_BUS bus='user space'
work=$(mktemp -d)
unit=''
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [[ -z $unit ]] || kill "$unit" 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT

start() {
  LD_PRELOAD='' "${as_service[@]}" "$bin/axisd" --interface "$interface" --node-id "$node" --axes "$axes" \
    --state-directory "$work/state" --control "$work/control" 2>"$work/log" &
  unit=$!
  until grep -q 'ready:' "$work/log"; do
    kill -0 "$unit" 2>/dev/null || { cat "$work/log" >&2; die "axisd ended before it was ready"; }
    sleep 0.1
  done
}

# status KEY: the number of that name in the status of the unit.
status() { "$bin/axisctl" --socket "$work/control" --json status | sed -n 's/.*"'"$1"'":\([0-9]*\).*/\1/p'; }

# write INDEX SIZE VALUE: an expedited download to every axis.
write() {
  local axis index bytes
  for ((axis = 0; axis < axes; ++axis)); do
    index=$(($1 + axis * axis_objects))
    printf -v bytes '%02X%02X%02X00%02X%02X%02X%02X' $((0x23 | (4 - $2) << 2)) $((index & 255)) $((index >> 8)) \
      $(($3 & 255)) $(($3 >> 8 & 255)) $(($3 >> 16 & 255)) $(($3 >> 24 & 255))
    cansend vcan0 "$sdo#$bytes"
  done
  sleep 0.2
}

turn() {
  cansend vcan0 000#0100
  write 0x6040 2 6
  write 0x6040 2 7
  write 0x6040 2 15
  write 0x60FF 4 70000000
  sleep 5
}

all_turn() {
  local turning
  turning=$("$bin/axisctl" --socket "$work/control" --json status | grep -o '"speed_rpm":[1-9][0-9]\{2\}' | wc -l)
  ((turning == axes)) || die "$turning of $axes axes turn"
}

# flood FRAMES: so many RPDOs; how many the unit has taken.
flood() {
  local before
  before=$(status received)
  "$bin/bus_client" vcan0 "$node" --controlword 000F "flood:$1" >/dev/null || true
  echo $(($(status received) - before - 1))  # the client asks once whether it is over
}

warm_up() {
  local burst
  for ((burst = 0; burst < 4; ++burst)); do
    (($(flood 200) == 200)) || die "a burst of 200 frames was not taken"
    sleep 0.2
  done
}

for ((run = 0; run < runs; ++run)); do
  start
  turn
  all_turn
  buffer=$(sed -n 's/.*receive buffer of \([0-9]*\) bytes.*/\1/p' "$work/log" | head -1)
  warm_up
  skipped=$(status skipped_cycles)
  taken=$(flood "$frames")
  all_turn
  echo "| $bus | ${buffer:-} | $frames | $taken | $((frames - taken)) | $(($(status skipped_cycles) - skipped)) |"
  kill -TERM "$unit"
  wait "$unit" || die "axisd ended with status $?"
  unit=''
done
