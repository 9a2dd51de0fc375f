#!/usr/bin/env bash
# Services under systemd: the version before is enabled, upgraded while it runs, joined by the units of a configuration, removed.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

# show UNIT PROPERTY: its value.
show() { systemctl show -P "$2" "$1"; }
expect_active() { [[ $(show "$1" ActiveState) == active ]] || fail "$1 is $(show "$1" ActiveState): $(journalctl -n 20 --no-pager -u "$1")"; }
has_answered() { grep -qF " $1" /run/try/frames; }

# ask REQUEST ANSWER: of an SDO request on the interface vcan0, which exists.
ask() {
  timeout 60 candump -L "vcan0,${2%%#*}:7FF" >/run/try/frames &
  sleep 1
  cansend vcan0 "$1"
  within 30 has_answered "$2" || fail "no answer $2 to $1: $(</run/try/frames)"
  kill %%
  wait
}

echo 'AXISD_OPTIONS="--node-id 5"' >/etc/default/axisd@vcan0
systemctl enable --now vcan@vcan0 axisd@vcan0
expect_active axisd@vcan0
ask 605#4000100000000000 585#430010009201FFFF
axisctl set 1/p1120 2.5 >/dev/null
axisctl store >/dev/null
within 60 is_stored || fail "nothing was stored: $(axisctl storage status)"
before=$(show axisd@vcan0 MainPID)
echo "-- version before: $(axisctl --json status | grep -oE '"version":"[^"]*"')"

install_packages /packages/*.deb
expect_active axisd@vcan0
[[ $(show axisd@vcan0 MainPID) != "$before" ]] || fail "the unit was not started again by the upgrade"
axisctl wait ready --timeout 60
echo "-- version after: $(axisctl --json status | grep -oE '"version":"[^"]*"')"
[[ $(ramp_up_time) == 2.5 ]] || fail "p1120 is $(ramp_up_time) after the upgrade"
getent group axisd >/dev/null || fail "there is no group axisd"
ps -o user:20,group:20,nlwp,args -C axisd
ls -l /run/axisd/vcan0

# The control socket for the group, whose members reach the unit; others do not.
echo 'AXISD_OPTIONS="--node-id 5 --control-group axisd"' >/etc/default/axisd@vcan0
systemctl restart axisd@vcan0
ls -l /run/axisd/vcan0
useradd --groups axisd member
useradd other
as_user() { setpriv --reuid="$1" --regid="$1" --init-groups axisctl --brief status; }
within 30 as_user member || fail "a member of the group does not reach the unit"
as_user other 2>/run/try/other && fail "somebody outside the group reaches the unit"
cat /run/try/other

echo '{"units": [{"interface": "vcan1", "node_id": {"from": 10, "to": 12}}, {"interface": "unix:/run/axisd/configured-units/can-bus"}]}' \
  >/etc/axisd/axisd.json
systemctl start vcan@vcan1
systemctl enable --now axisd.service
expect_active axisd.service
expect_active axisd@vcan0
axisctl --brief units
ls -l /run/axisd/configured-units
if [[ -e /usr/bin/axisd-http ]]; then
  systemctl enable --now axisd-http
  expect_active axisd-http
  # By the group it reaches the unit that lets it.
  within 60 http_has /api/v1/units vcan0 || fail "axisd-http does not have the unit: $(http /api/v1/units)"
  http /api/v1/units | tail -n 1
  ls -l /var/lib/private/axisd-http
  [[ $(stat -c %a /var/lib/private/axisd-http/token) == 600 ]] || fail "the token can be read by others"
fi
if [[ -e /usr/bin/axisd-agent ]]; then
  # shellcheck source=packaging/try/farm.sh
  . "${0%/*}/farm.sh"
fi
# One goes, the other stays with its folders.
systemctl stop axisd.service
expect_active axisd@vcan0
[[ -S /run/axisd/vcan0/axisd-vcan0-5.sock ]] || fail "the socket of axisd@vcan0 went with axisd.service"
systemctl start axisd.service

echo '{"no_such_key": 1}' >/etc/axisd/axisd.json
systemctl restart axisd.service && fail "axisd.service was started with a wrong configuration"
journalctl -o cat --no-pager -n 20 -u axisd.service | grep -F no_such_key
[[ $(show axisd.service NRestarts) == 0 ]] || fail "a wrong configuration was tried again"
echo '{"units": [{"interface": "vcan1"}]}' >/etc/axisd/axisd.json
systemctl reset-failed axisd.service
systemctl start axisd.service

mapfile -t packages < <(for file in /packages/*.deb; do dpkg-deb -f "$file" Package; done)
apt-get remove -y -qq "${packages[@]}" >/run/try/apt 2>&1 || fail "$(</run/try/apt)"
pgrep axisd && fail "programs are running after remove"
[[ $(find /var/lib/private/axisd -name parameters.bin) ]] || fail "the state is gone after remove"
dpkg --purge "${packages[@]}" >/run/try/dpkg 2>&1 || fail "$(</run/try/dpkg)"
left=$(find / -xdev \( -path /proc -o -path /run -o -path /packages -o -path /before -o -path /try -o -path /var/lib/dpkg -o -path /var/cache \
  -o -path /var/log \) -prune -o \( -name '*axisd*' -o -name '*can-userbus*' -o -name '*canopen*' \) -print)
# The options were written by the administrator.
[[ $left == /etc/default/axisd@vcan0 ]] || fail "left after purge: $left"
[[ -z $(systemctl list-units --all --no-legend 'axisd*') ]] || fail "systemd still knows: $(systemctl list-units --all 'axisd*')"
echo "-- stopped, removed, purged"
