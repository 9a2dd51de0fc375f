#!/usr/bin/env bash
# The upgrade: what was saved with the version before holds; a configuration that cannot be used is said in one line.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

before=$(dpkg-query -W -f '${Version}' axisd)
install_packages /packages/*.deb
after=$(dpkg-query -W -f '${Version}' axisd)
dpkg --compare-versions "$before" lt "$after" || fail "axisd is $after after an upgrade from $before"
echo "axisd $before -> $after"
sha256sum --quiet -c /var/lib/try.sum
start_unit
[[ $(ramp_up_time) == 2.5 ]] || fail "p1120 is $(ramp_up_time), 2.5 s had been saved: $(</run/try/log)"
is_stored || fail "the values are not those that were stored: $(axisctl storage status)"
end_unit

echo '{"interface": "unix:", "node_id": 5, "no_such_key": 1}' >/etc/axisd/old.json
status=0
axisd --config /etc/axisd/old.json --state-directory "$state" 2>/run/try/log || status=$?
[[ $status == 2 && $(wc -l </run/try/log) == 1 ]] || fail "status $status, expected 2 and one line: $(</run/try/log)"
cat /run/try/log
sha256sum --quiet -c /var/lib/try.sum
rm /etc/axisd/old.json
