#!/usr/bin/env bash
# bus_cost.sh [--build DIR] [--quick]: what a slave costs on a bus, kernel included, as Markdown.
#
# A plain node of the library with 4 + 4 and with 64 + 64 PDOs (bus_slave) and axisd, on the same loop, beside a program
# that does nothing but poll, read and write (can_echo): all in one start of a virtual machine with one processor on
# which an instruction takes 1 ns. The figures repeat to 0.3 %, whatever else this machine does. Takes two minutes.
#
# --build   the build with the programs (build/release, built first if it is this one)
# --quick   a tenth of the requests: good for a comparison, 0.5 %
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/../scripts/common.sh"
cd "$root"

build=build/release inside='' times=10
while (($#)); do
  case $1 in
    --build) build=${2:-}; [[ $build ]] || misuse "--build needs a folder"; shift 2 ;;
    --quick) times=1; shift ;;
    --inside) inside=yes; shift ;;
    *) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2 ;;
  esac
done

programs=(axisd axisctl can_echo bus_client bus_slave)
if [[ ! $inside ]]; then
  [[ $build != build/release ]] || build release "${programs[@]}" >&2
  for program in "${programs[@]}"; do [[ -x $build/bin/$program ]] || die "$build/bin/$program is not there"; done
  words=(--inside --build "$build")
  ((times > 1)) || words+=(--quick)
  exec scripts/vcan-vm --icount --timeout 1800 -- bench/bus_cost.sh "${words[@]}"
fi

readonly node=1 frames=50000
# In front of the client, so that a slave always finishes its turn first and every run is like the other.
readonly first=(chrt -f 50)
slave=''
work=$(mktemp -d)
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [[ -z $slave ]] || kill "$slave" 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT

# start COMMAND...: a slave in the background, until it says that it is ready.
start() {
  : >"$work/log"
  "$@" 2>>"$work/log" &
  slave=$!
  until grep -q ready "$work/log"; do
    kill -0 "$slave" 2>/dev/null || { cat "$work/log" >&2; die "$1 ended before it was ready"; }
    sleep 0.1
  done
  sleep 2  # a second after its start axisd gives back memory, and brings in again what it wants of that
}

# stop: ends the slave in order; what it said last is in the log.
stop() {
  kill -TERM "$slave"
  wait "$slave" || die "the slave ended with status $?"
  slave=''
}

# ask NAME OPTION... TEST...: lines "NAME TEST_WHAT NUMBER" to the figures.
ask() {
  local name=$1
  shift
  "$build/bin/bus_client" vcan0 "$node" --process "$slave" "$@" | sed "s/^/$name /" >>"$work/figures"
}

# measure NAME OPTION... -- COMMAND...
measure() {
  local name=$1 options=()
  shift
  while [[ $1 != -- ]]; do options+=("$1"); shift; done
  shift
  start "${first[@]}" "$@"
  ask "$name" "${options[@]}" heartbeat:100 synchronous start \
    "upload:$((2000 * times))" "download:$((500 * times))" "sync:$((200 * times))" idle:10
  stop
}

# flood NAME COMMAND...: without precedence, as far as the receive buffer carries.
flood() {
  local name=$1
  shift
  start "$@"
  ask "$name" start "flood:$frames"
  stop
  sed -n "s/^rpdos /$name flood_taken /p" "$work/log" >>"$work/figures"
}

# received: frames that axisd took so far.
received() {
  "$build/bin/axisctl" --socket "$work/control" --json status | sed -n 's/.*"received":\([0-9]*\).*/\1/p'
}

# flood_axisd: as flood; the count is that of its status, without the request that ends the flood.
flood_axisd() {
  local before
  start "${axisd[@]}" --control "$work/control"
  ask axisd start
  before=$(received)
  ask axisd "flood:$frames"
  echo "axisd flood_taken $(($(received) - before - 1))" >>"$work/figures"
  stop
}

bin=$build/bin
axisd=("$bin/axisd" --interface vcan0 --node-id "$node" --state-directory "$work/state")
measure echo4 -- "$bin/can_echo" vcan0 "$node" 4
measure slave4 -- "$bin/bus_slave" vcan0 "$node" --pdos 4
measure axisd --object 60FF -- "${axisd[@]}" --control none
measure echo32 --pdos 32 -- "$bin/can_echo" vcan0 "$node" 32
measure axisd8 --object 60FF --pdos 32 --axes 8 -- "${axisd[@]}" --axes 8 --control none
measure echo64 --pdos 64 -- "$bin/can_echo" vcan0 "$node" 64
measure slave64 --pdos 64 -- "$bin/bus_slave" vcan0 "$node" --pdos 64
flood echo4 "$bin/can_echo" vcan0 "$node"
flood slave4 "$bin/bus_slave" vcan0 "$node" --pdos 4
flood slave64 "$bin/bus_slave" vcan0 "$node" --pdos 64
flood_axisd

awk '
  { figure[$1, $2] = $3 }
  # A line of the table: the floor, and every slave with its ratio to it.
  function line(text, goal, name, echo, slaves,    list, n, i, value, floor) {
    floor = figure[echo, name]
    printf "| %s | %s | %d |", text, goal, floor
    n = split(slaves, list, " ")
    for (i = 1; i <= n; ++i) {
      value = figure[list[i], name]
      if (list[i] == "-") printf " |"; else printf " %d (%.3f) |", value, value / floor
    }
    print ""
  }
  # The same where only the numbers count.
  function plain(text, goal, name) {
    printf "| %s | %s | %d | %d | %d | %d |\n", text, goal, figure["echo4", name], figure["slave4", name],
      figure["slave64", name], figure["axisd", name]
  }
  END {
    every = "slave4 slave64 axisd"
    print "| instructions (ratio) | goal | poll + read + write | bus_slave 4 + 4 | bus_slave 64 + 64 | axisd |"
    print "|---|---:|---:|---:|---:|---:|"
    line("SDO upload, CPU", "1.10", "upload_cpu", "echo4", every)
    line("SDO upload, round trip p50", "", "upload_p50", "echo4", every)
    line("SDO upload, round trip p99", "", "upload_p99", "echo4", every)
    line("SDO download, CPU", "1.10", "download_cpu", "echo4", every)
    line("SYNC to 4th TPDO, p50", "1.05", "sync_p50", "echo4", "slave4 - axisd")
    line("SYNC to 4th TPDO, p99", "", "sync_p99", "echo4", "slave4 - axisd")
    line("SYNC to 4 TPDOs, CPU", "", "sync_cpu", "echo4", "slave4 - axisd")
    line("SYNC to 32nd TPDO, p50", "", "sync_p50", "echo32", "- - axisd8")
    line("SYNC to 32 TPDOs, CPU", "1.04", "sync_cpu", "echo32", "- - axisd8")
    line("SYNC to 64th TPDO, p50", "", "sync_p50", "echo64", "- slave64 -")
    line("SYNC to 64 TPDOs, CPU", "1.04", "sync_cpu", "echo64", "- slave64 -")
    line("idle with a heartbeat every 100 ms, CPU a second", "1.3", "idle_cpu", "echo4", every)
    line("eight axes: SDO upload, CPU", "1.10", "upload_cpu", "echo32", "- - axisd8")
    line("eight axes: SDO download, CPU", "1.10", "download_cpu", "echo32", "- - axisd8")
    line("eight axes: idle, CPU a second", "1.3", "idle_cpu", "echo32", "- - axisd8")
    line("RPDO in a flood, CPU", "", "flood_cpu", "echo4", every)
    plain("heartbeat period of 100 ms, p50 (ns)", "", "heartbeat_p50")
    plain("heartbeat period of 100 ms, p99 (ns)", "", "heartbeat_p99")
    plain("RPDOs taken of '"$frames"' back to back", "all", "flood_taken")
  }' "$work/figures"
