# shellcheck shell=bash
# What the scripts of this folder share, which scripts/package.sh runs in a clean root with the packages in /packages; to be sourced.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 CAN_BUS=/run/try/can-bus
state=/var/lib/axisd
mkdir -p /run/try && chmod 0700 /run/try

# fail TEXT...: what was expected, and the end.
fail() { echo "$*" >&2; exit 1; }

# within SECONDS COMMAND...: repeats COMMAND until it succeeds.
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < end)) || return 1
    sleep 0.1
  done
}

# start_unit [OPTION]...: a unit with node-ID 5 on a bus in user space, with its state where that of the services lies.
start_unit() {
  axisd --interface unix: --node-id 5 --state-directory "$state" "$@" 2>/run/try/log &
  unit=$!
  axisctl wait ready --timeout 30 || fail "the unit did not start: $(</run/try/log)"
}

# end_unit: switches it off.
end_unit() {
  local status=0
  kill "$unit"
  wait "$unit" || status=$?
  [[ $status == 0 ]] || fail "the unit ended with $status: $(</run/try/log)"
}

# answers REQUEST ANSWER: whether the unit answers an SDO request; both as candump prints them. The request is repeated, for the
# listener joins the bus when it can.
answers() {
  local end=$((SECONDS + 20)) listener
  : >/run/try/frames
  with-can -- candump -L "vcan0,${2%%#*}:7FF" >>/run/try/frames &
  listener=$!
  until grep -qF " $2" /run/try/frames || ((SECONDS >= end)); do
    with-can -- cansend vcan0 "$1"
    sleep 0.1
  done
  kill "$listener"
  wait "$listener" || true
  grep -qF " $2" /run/try/frames
}

# is_stored: whether what the unit has is what is saved.
is_stored() { axisctl storage status | grep -qx 'is_stored: true'; }

# ramp_up_time: p1120 of axis 1.
ramp_up_time() { axisctl --json get 1/p1120 | grep -oE '"value":[0-9.]+' | cut -d: -f2; }

# http PATH: the answer of axisd-http, with its head. There is no client of HTTP in the clean root.
http() {
  exec 3<>/dev/tcp/127.0.0.1/8402 || return
  printf 'GET %s HTTP/1.1\r\nHost: 127.0.0.1:8402\r\nConnection: close\r\n\r\n' "$1" >&3
  timeout 20 cat <&3
  exec 3<&-
}

# http_has PATH TEXT: whether the answer has it.
http_has() { http "$1" 2>/dev/null | grep -F "$2" >/dev/null; }

# install PACKAGE_FILE...: with what it depends on, from what has been downloaded.
install_packages() { apt-get install -y -qq --no-install-recommends "$@" >/run/try/apt 2>&1 || fail "$(</run/try/apt)"; }
