#!/usr/bin/env bash
# test.sh [--quick]: builds the project and runs every test, on a fresh Debian 12 machine too.
#
# In order: packages; form of the sources; release and sanitizer builds with their unit tests; the end-to-end tests, for
# which npm brings an independent master, on user-space buses and then on a CAN interface (where the kernel has none: in
# one start of the virtual machine); clang-tidy. A failure does not keep the rest from running. A test that was skipped
# counts as failed, for it has shown nothing.
#
# --quick: the release build and its unit tests only.
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

# tests LEVEL COMMAND...: a run of ctest, counted test by test.
tests() {
  local level=$1 from=$SECONDS status bad all skipped disabled
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
  record "$level" $((all - bad)) $((bad + disabled)) $((SECONDS - from))
}

[[ $quick ]] || check 'format' scripts/lint.sh --format-only
if check 'build release' build release; then
  tests 'unit release' ctest --preset release -j "$jobs"
  released=yes
fi
if [[ ! $quick ]]; then
  if check 'build asan' build asan; then
    tests 'unit asan' ctest --preset asan -j "$jobs"
  fi
  if [[ ${released:-} ]]; then
    check 'npm packages' need_master
    # Each has a bus of its own.
    tests 'user-space bus' ctest --test-dir build/release -L '^bus$' -j "$jobs" --output-on-failure --no-tests=error
    # One after the other: they share the bus.
    tests 'SocketCAN' run_on_can ctest --test-dir build/release -L '^e2e$' --output-on-failure --no-tests=error
    check 'clang-tidy' scripts/lint.sh --tidy-only
  fi
fi

echo
printf '%s\n' "${rows[@]}"
printf 'in total %d s\n' $((SECONDS - started))
echo "$passed passed, $failed failed"
((failed == 0))
