#!/usr/bin/env bash
# axisd is removed while a unit runs: that goes on, and keeps what it knows when it is switched off.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

start_unit
axisctl set 1/p1120 3.5 >/dev/null
apt-get remove -y -qq axisd >/run/try/apt 2>&1 || fail "$(</run/try/apt)"
[[ ! -e /usr/bin/axisd && -e /usr/bin/with-can ]] || fail "the programs are still there"
answers 605#4000100000000000 585#430010009201FFFF || fail "the unit does not answer after the removal of its package"
# 2460h: p1120; what it is now is saved ("save" to 1010h:01).
answers 605#2310100173617665 585#6010100100000000 || fail "the unit does not save after the removal of its package"
end_unit
install_packages /packages/*.deb
start_unit
[[ $(ramp_up_time) == 3.5 ]] || fail "p1120 is $(ramp_up_time), 3.5 s had been saved"
end_unit
