#!/usr/bin/env bash
# Remove keeps configuration and state, purge leaves nothing: /var/lib/try.files has the files of before the first installation.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

mapfile -t packages < <(for file in /packages/*.deb; do dpkg-deb -f "$file" Package; done)
echo '{"units": [{"interface": "unix:/run/axisd/configured-units/can-bus"}]}' >/etc/axisd/axisd.json
mkdir -p /etc/systemd/system/sys-subsystem-net-devices-vcan0.device.wants
ln -s /lib/systemd/system/axisd@.service /etc/systemd/system/sys-subsystem-net-devices-vcan0.device.wants/axisd@vcan0.service
apt-get remove -y -qq "${packages[@]}" >/run/try/apt 2>&1 || fail "$(</run/try/apt)"
grep -q configured-units /etc/axisd/axisd.json || fail "the configuration is gone after remove"
[[ $(find "$state" -name parameters.bin) ]] || fail "the state is gone after remove"
dpkg --purge "${packages[@]}" >/run/try/apt 2>&1 || fail "$(</run/try/apt)"
apt-get autoremove --purge -y -qq >/run/try/apt 2>&1 || fail "$(</run/try/apt)"
rm -rf /run/try /tmp/can-bus* /var/lib/try.sum
"${0%/*}/files.sh" >/tmp/files
diff /var/lib/try.files /tmp/files || fail "other files than before the first installation"
rm /tmp/files
