#!/usr/bin/env bash
# demo.sh [--interface IF]: starts the simulated drive on a CAN interface (vcan0) and runs its motor up to 3000 rpm and
# back to standstill with nothing but cansend and candump; checks every answer on the bus.
#
# Does its own set-up (packages, build, bus), so it works on a fresh Debian 12 machine. Where the kernel has no CAN,
# everything runs on the user-space bus of this project instead (docs/explanation/user-space-bus.md), without any privilege beyond
# that of installing packages. IF other than vcan... must exist and be up.
# Ends with 1, and says what was expected and what came, if an answer does not come in time.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

interface=vcan0 set_up=yes
while (($#)); do
  case $1 in
    --interface) interface=${2:?"an interface is missing"}; shift 2 ;;
    --no-set-up) set_up=''; shift ;;  # how this script calls itself on another bus
    *) echo "usage: ${0##*/} [--interface IF]" >&2; exit 2 ;;
  esac
done

is_up() { [[ $(ip -o link show dev "$interface" up 2>/dev/null) ]]; }

if [[ $set_up ]]; then
  # shellcheck source=scripts/setup.sh
  . "$root/scripts/setup.sh" --demo
  build release axisd canhub with-can can-preload
  if ! is_up && [[ $interface == vcan* ]] && ! "$root/scripts/vcan-setup.sh" "$interface" 2>/dev/null; then
    say "this kernel has no virtual CAN: running on a user-space bus"
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    "$root/build/release/bin/with-can" --bus "$folder/bus" -- \
      "$root/scripts/demo.sh" --no-set-up --interface "$interface"
    exit
  fi
fi

served=$interface
if [[ ${CAN_BUS:-} ]]; then
  served=unix:$CAN_BUS
else
  case $interface in
    can0 | can1)
      if [[ ${VCAN_VM:-} ]]; then
        # Both ends of the emulated bus, for a controller alone would get no acknowledgement on a real one either.
        for name in can0 can1; do ip link set "$name" up type can bitrate 500000; done
      fi ;;
  esac
  is_up || die "the interface $interface does not exist or is down"
fi

# ---- the bus as this run sees it

limit=5  # seconds for an answer
[[ ! ${VCAN_VM:-} ]] || limit=30  # software emulation may be ten times slower
work=$(mktemp -d) children=()
frames=$work/frames log=$work/axisd.log
mark=0  # lines of $frames before the last frame that was sent

# shellcheck disable=SC2317  # called by the trap
clean_up() {
  ((${#children[@]} == 0)) || kill "${children[@]}" 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# within SECONDS COMMAND...: repeats COMMAND until it succeeds; fails when the time is up or the drive is gone.
within() {
  local end=$((SECONDS + $1 + 1))
  shift
  until "$@"; do
    ((SECONDS < end)) || return 1
    [[ ! ${drive:-} ]] || kill -0 "$drive" 2>/dev/null || return 1
    sleep 0.05
  done
}

show() { printf '  %-8s  %-22s  %s\n' "$@"; }

# missing EXPECTED MEANING: the report of an answer that did not come.
missing() {
  {
    echo "expected  $1  ($2)"
    echo "received  since the last frame sent:"
    tail -n +$((mark + 1)) "$frames" | awk '{ print "          " $3 } NR == 20 { print "          ..."; exit }'
    if ! kill -0 "$drive" 2>/dev/null; then
      echo "axisd has ended; its last lines:"
      tail -n 5 "$log"
    fi
  } >&2
  exit 1
}

# send FRAME MEANING
send() {
  mark=$(wc -l <"$frames")
  cansend "$interface" "$1"
  show send "$1" "$2"
}

# received PATTERN: whether a frame that matches came since the last one was sent; leaves it in `frame`.
received() {
  frame=$(awk -v from="$mark" -v pattern="^$1\$" 'NR > from && $3 ~ pattern { print $3; exit }' "$frames")
  [[ $frame ]]
}

# expect PATTERN MEANING: waits for the answer to the last frame that was sent.
expect() {
  within "$limit" received "$1" || missing "$1" "$2"
  show receive "$frame" "$2"
}

# exchange FRAME MEANING PATTERN MEANING
exchange() { send "$1" "$2"; expect "$3" "$4"; }

# What all the readers of TPDO2 (285h: statusword, velocity actual value in inc/s, both little endian) have in common.
# awk of a fresh Debian knows no hexadecimal numbers. One turn is 2^22 inc.
reading='
  function number(text, first, bytes,   i, value) {
    for (i = first + 2 * (bytes - 1); i >= first; i -= 2)
      value = 256 * value + 16 * digit[substr(text, i, 1)] + digit[substr(text, i + 1, 1)]
    return value
  }
  function rpm(frame,   velocity) {
    velocity = number(frame, 9, 4)
    if (velocity >= 2147483648) velocity -= 4294967296
    return velocity * 60 / 4194304
  }
  function is_velocity(frame) { return frame ~ /^285#[0-9A-F]+$/ && length(frame) == 16 }
  BEGIN { for (i = 0; i < 16; i++) digit[substr("0123456789ABCDEF", i + 1, 1)] = i }'

# at_speed RPM: whether a TPDO2 since the last frame sent says RPM, give or take 3 rpm (0.1 % of the rated speed).
at_speed() {
  frame=$(awk -v from="$mark" -v wanted="$1" "$reading"'
    NR > from && is_velocity($3) && rpm($3) >= wanted - 3 && rpm($3) <= wanted + 3 { print $3; exit }' "$frames")
  [[ $frame ]]
}

# expect_speed RPM: waits for it, longer than for an answer, for the ramp takes its time.
expect_speed() {
  within $((limit + 5)) at_speed "$1" || missing "285# with $1 rpm, +-0.1 % of 3000 rpm" "velocity actual value"
  show receive "$frame" "$(awk -v frame="$frame" "$reading"'
    BEGIN { printf "statusword %04Xh, velocity actual value %.1f rpm", number(frame, 5, 2), rpm(frame) }')"
  [[ $frame == 285#37* ]] || missing "285#37.........." "statusword: operation enabled"
}

# chart: speed over time since the last frame sent, from the TPDO2 of this run.
chart() {
  awk -v from="$mark" "$reading"'
    NR <= from { next }
    { time = substr($1, 2) + 0 }
    start == "" { start = time }
    is_velocity($3) {
      at[++count] = time - start
      speed[count] = rpm($3)
      if (speed[count] > top) top = speed[count]
    }
    END {
      width = 64
      step = 250  # rpm a line
      lines = int(top / step)
      if (lines * step < top - 5) lines++
      for (i = 1; i <= count; i++) {
        column = int(at[i] / at[count] * (width - 1))
        value[column] = speed[i]
        known[column] = 1
      }
      for (column = 0; column < width; column++) {
        if (column in known) last = value[column]
        else if (!(0 in known) && last == "") last = speed[1]
        row[column] = int(last / step + 0.5)
      }
      print "\n   rpm"
      for (line = lines; line >= 0; line--) {
        text = ""
        for (column = 0; column < width; column++) text = text (row[column] == line ? "*" : " ")
        sub(/ +$/, "", text)
        printf "  %4s |%s\n", line % 2 ? "" : line * step, text
      }
      axis = ""
      scale = ""
      for (column = 0; column < width; column++) axis = axis (column % 16 ? "-" : "+")
      for (column = 0; column <= width; column += 16) scale = scale sprintf("%-16.2f", column / width * at[count])
      printf "       %s\n       %s s   (%d frames 285h)\n\n", " " axis "+", scale, count
    }' "$frames"
}

# ---- start

# A frame that nobody takes for anything comes back to candump once that listens.
is_listening() { cansend "$interface" 7FF# && grep -q ' 7FF#' "$frames"; }
is_ready() { grep -q 'ready: node' "$log"; }

say "candump -L $interface"
candump -L "$interface" >"$frames" &
children+=($!)
within "$limit" is_listening || die "candump does not listen on $interface"

say "axisd --interface $served --node-id 5"
mkdir "$work/state" "$work/run"
RUNTIME_DIRECTORY=$work/run "$root/build/release/bin/axisd" --interface "$served" --node-id 5 \
  --state-directory "$work/state" >"$log" 2>&1 &
drive=$!
children+=("$drive")
within $((limit + 5)) is_ready || {
  echo "axisd did not become ready; its last lines:" >&2
  tail -n 5 "$log" >&2
  exit 1
}

# ---- a small master

say "the drive comes up"
expect '705#00' 'boot-up'
exchange '605#4000100000000000' 'SDO: read 1000h, device type' '585#430010009201FFFF' 'FFFF0192h: drive, CiA 402'

say "ramps: 104857600 inc/s2, 3000 rpm in two seconds"
exchange '605#2383600000004006' 'SDO: write 6083h, profile acceleration' '585#6083600000000000' 'written'
exchange '605#2384600000004006' 'SDO: write 6084h, profile deceleration' '585#6084600000000000' 'written'

say "switching on"
send '000#0105' 'NMT: start node 5'
exchange '205#0600' 'controlword: shutdown' '185#3116' 'statusword 1631h: ready to switch on'
exchange '205#0700' 'controlword: switch on' '185#3316' 'statusword 1633h: switched on'
exchange '205#0F00' 'controlword: enable operation' '185#3716' 'statusword 1637h: operation enabled'

say "setpoint 3000 rpm"
send '305#0F000000800C' 'controlword, target velocity 209715200 inc/s'
expect_speed 3000
chart

say "setpoint 0"
send '305#0F0000000000' 'controlword, target velocity 0'
expect_speed 0
chart

say "switching off"
exchange '205#0600' 'controlword: shutdown' '185#31..' 'statusword: ready to switch on'
# The last increments fade without current: asked until the shaft rests.
standing_still() {
  mark=$(wc -l <"$frames")
  cansend "$interface" '605#406C600000000000'
  within 1 received '585#436C6000........' && [[ $frame == '585#436C600000000000' ]]
}
show send '605#406C600000000000' 'SDO: read 606Ch, velocity actual value'
within "$limit" standing_still || missing '585#436C600000000000' 'velocity actual value 0'
show receive "$frame" 'velocity actual value 0'

say "power off"
kill -TERM "$drive"
status=0
wait "$drive" || status=$?
((status == 0)) || die "axisd ended with exit status $status instead of 0: $(tail -n 1 "$log")"
say "done: every answer came as expected"
