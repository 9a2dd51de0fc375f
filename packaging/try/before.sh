#!/usr/bin/env bash
# The version before, a value saved with it.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

install_packages /before/*.deb
[[ $(axisd --version) != "$NEW_VERSION"* ]] || fail "the version before calls itself $(axisd --version)"
axisd --version
start_unit
axisctl set 1/p1120 2.5 >/dev/null
axisctl store >/dev/null
within 20 is_stored || fail "nothing was stored: $(axisctl storage status)"
end_unit
sha256sum "$state"/*/parameters.bin >/var/lib/try.sum
