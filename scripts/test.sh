#!/usr/bin/env bash
# test.sh [--quick]: builds the project and runs every test, on a fresh Debian 12 machine too.
#
# In order: packages; form of the sources; the sanitizer build of what unit tests need, and these; the release build of
# everything else, with the unit tests that cannot be in the former and those of the package; the end-to-end tests, for
# which npm brings an independent master, on user-space buses and then on a CAN interface (where the kernel has none: in
# one start of the virtual machine); clang-tidy over what the last commit changed. A failure does not keep the rest from
# running. A test that was skipped
# counts as failed, for it has shown nothing.
#
# --quick: the whole release build and its unit tests only.
#
# The last line is "N passed, M failed"; the exit status is 0 if M is 0.
set -uo pipefail
started=$SECONDS

quick=''
case ${1:-} in
  '') ;;
  --quick) quick=yes ;;
  *) echo "usage: ${0##*/} [--quick]" >&2; exit 2 ;;
esac
# shellcheck source=scripts/setup.sh
. "$(dirname "$0")/setup.sh" ""
set +e  # from here on a failure is counted
cd "$root" || exit 1

log=$(mktemp)
trap 'rm -f "$log"' EXIT
passed=0 failed=0 rows=()

# record LEVEL PASSED FAILED SECONDS: one row of the closing table.
record() {
  rows+=("$(printf '%-16s %5d passed %5d failed %6d s' "$@")")
  passed=$((passed + $2)) failed=$((failed + $3))
}

# check LEVEL COMMAND...: a step that counts as one test.
check() {
  local level=$1 from=$SECONDS
  shift
  if "$@"; then record "$level" 1 0 $((SECONDS - from)); else record "$level" 0 1 $((SECONDS - from)); return 1; fi
}

# tests LEVEL COMMAND...: a run of ctest, counted test by test; so are those within a program whose output is shown.
tests() {
  local level=$1 from=$SECONDS status bad all skipped disabled good_within bad_within good_programs bad_programs
  shift
  say "tests: $level"
  "$@" 2>&1 | tee "$log"
  status=${PIPESTATUS[0]}
  read -r bad all < <(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\).*/\1 \2/p' "$log")
  skipped=$(grep -cF '***Skipped' "$log")
  disabled=$(grep -cF '***Not Run (Disabled)' "$log")  # ctest leaves these out of its total
  ((bad = ${bad:-0} + skipped, all = ${all:-0}))
  # No test, or a failure that is none of a test (ctest's own, the virtual machine's), is one failure at least.
  ((bad > 0 || (status == 0 && all > 0))) || ((bad = 1, all += 1))
  # GoogleTest ends the output of a program with these lines; the tests in it stand for the program.
  read -r good_within bad_within good_programs bad_programs < <(awk '
    /\[  PASSED  \] [0-9]+ test/ {good += $(NF - 1); programs++}
    /\[  FAILED  \] [0-9]+ tests?, listed below/ {sub(/, listed below.*/, ""); bad += $(NF - 1); bad_programs++}
    END {print good + 0, bad + 0, programs - bad_programs, bad_programs + 0}' "$log")
  record "$level" $((all - bad - good_programs + good_within)) $((bad - bad_programs + bad_within + disabled)) \
    $((SECONDS - from))
}

# every_test_has_a_run: whether each test of the release build has a label that is run below. (A unit test that is not
# built has none.)
every_test_has_a_run() {
  local others
  others=$(ctest --test-dir build/release -N -LE '^(unit|optimised|package|bus|e2e|master)$' -E '_NOT_BUILT$') || return 1
  grep -q '^Total Tests: 0$' <<<"$others" || { echo "these tests are in no run of ${0##*/}:"; echo "$others"; return 1; }
}

# finish: the table, and the result as exit status.
finish() {
  echo
  printf '%s\n' "${rows[@]}"
  printf 'in total %d s\n' $((SECONDS - started))
  echo "$passed passed, $failed failed"
  exit $((failed > 0))
}

if [[ $quick ]]; then
  check 'build release' build release && tests 'unit release' ctest --preset release -j "$jobs"
  finish
fi

check 'format' scripts/lint.sh --format-only
if check 'build asan' build asan unit_tests; then
  # By program, the output of each shown, for its tests are counted; it has the failures only.
  tests 'unit asan' env GTEST_BRIEF=1 ctest --preset asan -L '^unit$' -j "$jobs" --verbose
fi
if check 'build release' build release end_to_end_tests; then
  check 'labels' every_test_has_a_run
  tests 'unit release' ctest --preset release -L '^(optimised|package)$' -j "$jobs"
  check 'npm packages' need_master
  # Each has a bus of its own.
  tests 'user-space bus' ctest --test-dir build/release -L '^bus$' -j "$jobs" --output-on-failure --no-tests=error
  # One after the other: they share the bus.
  tests 'SocketCAN' run_on_can ctest --test-dir build/release -L '^e2e$' --output-on-failure --no-tests=error
  check 'clang-tidy' scripts/lint.sh --tidy-changed
fi
finish
