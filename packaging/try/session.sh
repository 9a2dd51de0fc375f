#!/usr/bin/env bash
# A first session: all packages installed, a unit on a bus in user space, driven by cansend, looked into by axisctl.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

install_packages /packages/*.deb
mapfile -t programs < <(for file in /packages/*.deb; do dpkg-deb -c "$file"; done | sed -n 's|.* \./usr/bin/\(.\+\)$|\1|p')
((${#programs[@]} >= 6)) || fail "these programs are in the packages: ${programs[*]}"
for program in "${programs[@]}"; do
  version=$("$program" --version)
  [[ $version =~ ^$program\ [0-9.]+ ]] || fail "$program --version says: $version"
  echo "$version"
  [[ $(find /usr/share/man -name "$program.[18].gz") ]] || fail "no man page of $program"
done
axisd --check-config --config /etc/axisd/axisd.json

start_unit
answers 605#4000100000000000 585#430010009201FFFF || fail "no answer to the device type: $(</run/try/frames)"
with-can -- cansend vcan0 000#0105
axisctl wait nmt operational --timeout 20
for word in 0600 0700 0F00; do
  with-can -- cansend vcan0 205#$word
  sleep 0.1  # the unit looks at its process data every 4 ms
done
axisctl wait state 1 operation-enabled --timeout 20
with-can -- cansend vcan0 305#0F000000800C
axisctl wait value r0021 ge 2990 --timeout 60
axisctl --brief status
if [[ -e /usr/bin/axisd-http ]]; then
  axisd-http --token-file /run/try/token 2>/run/try/http &
  gateway=$!
  within 20 http_has /api/v1/units can-bus || fail "axisd-http does not have the unit: $(</run/try/http)"
  http_has /metrics axisd || fail "axisd-http has no metrics"
  kill "$gateway"
  wait "$gateway" || fail "axisd-http ended with $?: $(</run/try/http)"
fi
with-can -- cansend vcan0 205#0600
axisctl wait value r0021 lt 1 --timeout 60
edstool lint /usr/share/axisd/eds/axisd.eds
canopen-check --interface unix: --node 5 --eds /usr/share/axisd/eds/axisd.eds --deviations /usr/share/axisd/eds/axisd-deviations.json \
  --read-only | tail -n 2
printf '(1.0) can0 605#4000100000000000\n(1.0) can0 605#4001100000000000\n' >/run/try/overlap.log
said=$(canopen-audit /run/try/overlap.log) && fail "canopen-audit has nothing against a request before the answer to the last one: $said"
[[ $said == *sdo.overlap* ]] || fail "canopen-audit has not found sdo.overlap: $said"
axisctl store >/dev/null
within 20 is_stored || fail "nothing was stored: $(axisctl storage status)"
end_unit
if [[ -e /usr/lib/python3/dist-packages/axisd ]]; then
  said=$(python3 -c 'import axisd
with axisd.Unit() as drive:
    drive.nmt("start")
    drive.wait(nmt="operational")
    drive.switch_on()
    print(drive.state())') || fail "the module of Python has not started a unit"
  [[ $said == 'Operation enabled' ]] || fail "a unit of the module of Python is in the state $said"
fi
