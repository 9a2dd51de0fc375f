#!/usr/bin/env bash
# daemon_cost.sh [--build DIR] [--requests N]: what an SDO request costs the running daemon in user space, as Markdown.
#
# User-space instructions (callgrind) and system calls (strace) a request, each as the difference of 2 N and N requests
# divided by N (1000). On vcan0; in the virtual machine of scripts/vcan-vm where this kernel has no CAN. What the kernel
# adds is measured by bus_cost.sh.
#
# --build   the build with the programs (build/release, built first if it is this one)
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/../scripts/common.sh"
cd "$root"

build=build/release requests=1000 inside=''
while (($#)); do
  case $1 in
    --build) build=${2:-}; [[ $build ]] || misuse "--build needs a folder"; shift 2 ;;
    --requests) need_number "$@"; requests=$2; shift 2 ;;
    --inside) inside=yes; shift ;;
    *) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2 ;;
  esac
done

node=5
axisd=("$build/bin/axisd" --interface vcan0 --node-id "$node" --control none)
slave=''

# start NAME COMMAND...: a slave in the background, until it says that it is ready; what it says goes to NAME.log.
start() {
  local log=$work/$1.log
  shift
  : >"$log"
  "$@" 2>>"$log" &
  slave=$!
  until grep -q ready "$log"; do
    kill -0 "$slave" 2>/dev/null || { cat "$log" >&2; die "$1 ended before it was ready"; }
    sleep 0.1
  done
}

# stop: ends the slave in order.
stop() {
  kill -TERM "$slave"
  wait "$slave" || die "the slave ended with status $?"
  slave=''
}

# ask N: that many requests, each when the slave, slow under its counter, waits for one again.
ask() { "$build/bin/bus_client" vcan0 "$node" --pause 3000 "upload:$1" >/dev/null; }

# instructions N: of the daemon's whole life with N requests.
instructions() {
  start "callgrind$1" valgrind --tool=callgrind --callgrind-out-file=/dev/null \
    "${axisd[@]}" --state-directory "$work/state"
  ask "$1"
  stop
  sed -n 's/^==[0-9]*== Collected : \([0-9]*\).*/\1/p' "$work/callgrind$1.log"
}

# system_calls N: "NAME COUNT" lines of the daemon's whole life with N requests.
system_calls() {
  local trace=$work/strace$1
  start "strace$1" strace -D -f -qq -o "$trace" "${axisd[@]}" --state-directory "$work/state"
  ask "$1"
  stop
  # The tracer is a process of its own and may be a little behind.
  for ((i = 0; i < 100; ++i)); do
    grep -q '+++ exited' "$trace" && break
    sleep 0.1
  done
  sed -n 's/^[0-9]* *\([a-z0-9_]*\)(.*/\1/p' "$trace" | sort | uniq -c | awk '{print $2, $1}'
}

counts() {
  local once twice source
  once=$(instructions "$requests")
  twice=$(instructions $((2 * requests)))
  system_calls "$requests" >"$work/once"
  system_calls $((2 * requests)) >"$work/twice"
  echo '| axisd, per SDO request |  |'
  echo '|---|---:|'
  awk -v n="$requests" -v i=$((twice - once)) 'BEGIN { printf "| user-space instructions | %.0f |\n", i / n }'
  awk -v n="$requests" '
    NR == FNR { once[$1] = $2; next }
    { calls = ($2 - once[$1]) / n
      if (calls >= 0.005) { sum += calls; row = row sprintf("| of these `%s` | %.2f |\n", $1, calls) } }
    END { printf "| system calls | %.2f |\n%s", sum, row }' "$work/once" "$work/twice"
  source=$(</sys/devices/system/clocksource/clocksource0/current_clocksource)
  [[ $source == tsc ]] || printf '\nThe clock source here is %s; with tsc `clock_gettime` is no system call.\n' "$source"
}

# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [[ -z $slave ]] || kill "$slave" 2>/dev/null || true
  rm -rf "$work"
}

if [[ $inside ]]; then
  work=$(mktemp -d)
  trap clean_up EXIT
  counts
  exit
fi

missing=()
command -v valgrind >/dev/null || missing+=(valgrind)
command -v strace >/dev/null || missing+=(strace)
((${#missing[@]} == 0)) || { echo "${0##*/}: missing Debian packages: apt-get install ${missing[*]}" >&2; exit 2; }
[[ $build != build/release ]] || build release axisd bus_client >&2
run_on_can bench/daemon_cost.sh --inside --build "$build" --requests "$requests"
