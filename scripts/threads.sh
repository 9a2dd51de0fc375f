#!/usr/bin/env bash
# threads.sh: the unit tests of everything that has more than one thread, with the thread sanitizer (build/threads). A race that it
# finds is printed and makes the exit status 1.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

# Writers of files, loops of units, hubs and their members, connections to a NATS server, streams of axisd-http.
tests=(record_test daemon_test control_methods_test streams_test program_test hub_test hub_trunk_test hub_time_test hub_bridge_test bus_test bus_user_bus_test
  time_share_test nats_test gateway_server_test gateway_test canrec_test farm_link_test)

cmake --preset threads -S "$root" >/dev/null
known=$(cmake --build "$root/build/threads" --target help)
present=()
for test in "${tests[@]}"; do
  ! grep -q "^$test: phony$" <<<"$known" || present+=("$test")
done
((${#present[@]} == ${#tests[@]})) || die "of the tests ${tests[*]} there are only ${present[*]}"
build threads "${tests[@]}"
status=0
for test in "${tests[@]}"; do
  say "$test"
  # The sanitizer hands a signal on when the program waits next, so that one to itself is not there at once.
  TSAN_OPTIONS=exitcode=66:second_deadlock_stack=1 "$root/build/threads/bin/tests/$test" --gtest_brief=1 \
    --gtest_filter=-ServiceEvents.CallsForTheEndOnAHangUp || status=1
done
exit "$status"
