#!/usr/bin/env bash
# turn.sh: what a guest does to run the motor of node 5 up to 3000 rpm and to stop it again: qemu.sh turn.sh
set -euo pipefail

ip link set can0 up type can bitrate 500000
increments=4194304 # a revolution
exec 3< <(exec candump -L can0,185:7FF,285:7FF)
until grep -qE '^ *can0 ' /proc/net/can/rcvlist_fil; do sleep 0.1; done # candump listens

# await FRAME: until FRAME has come; shows it.
await() {
  while read -r -t 30 _ _ frame <&3; do
    [[ $frame != "$1" ]] || { echo "$frame"; return; }
  done
  echo "no $1 has come" >&2
  exit 1
}

# await_speed RPM: until the actual velocity in TPDO2 is RPM, rounded; shows it on the way there.
await_speed() {
  local bytes velocity speed shown=-1
  while read -r -t 30 _ _ frame <&3; do
    [[ $frame == 285#* ]] || continue
    bytes=${frame:8} # least significant first
    velocity=$((16#${bytes:6:2}${bytes:4:2}${bytes:2:2}${bytes:0:2}))
    ((velocity < 1 << 31)) || velocity=$((velocity - (1 << 32)))
    speed=$(((velocity * 60 + increments / 2) / increments))
    ((speed / 500 == shown && speed != $1)) || echo "$frame  $speed rpm"
    shown=$((speed / 500))
    ((speed != $1)) || return 0
  done
  echo "the motor has not reached $1 rpm" >&2
  exit 1
}

cansend can0 000#0105 # NMT: node 5 to Operational
sleep 0.1
cansend can0 205#8000 # whatever was before: no fault, no voltage
sleep 0.1
cansend can0 205#0600 # shutdown
await 185#3116
cansend can0 205#0700 # switch on
await 185#3316
cansend can0 205#0F00 # enable operation
await 185#3716
cansend can0 305#0F000000800C # 3000 rpm
await_speed 3000
cansend can0 205#0600 # OFF1: ramp down, then ready to switch on
await 185#3116
