#!/usr/bin/env bash
# test.sh [--quick]: builds the project and runs every test, on a fresh Debian 12 machine too.
#
# In order: packages; form of the sources; the release build of everything but the unit tests; the end-to-end tests, for which
# npm brings an independent master, on user-space buses. Then side by side:
# - the end-to-end tests on a CAN interface (where the kernel has none: in one start of the virtual machine);
# - the sanitizer build of what unit tests need, and these; the unit tests that cannot be in it, those of the page of axisd-http
#   and those of the package, in the release build; clang-tidy over what the last commit changed.
# What runs beside the rest is shown when it has ended, each part by itself. A failure does not keep the rest from running. A
# test that was skipped counts as failed, for it has shown nothing. A test on a bus that failed and then passed when it was
# repeated is named, and has passed.
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

# Of each part, by its number: its row of the closing table and, where it runs beside others, its output.
parts=$(mktemp -d) part=100 beside=()
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  for group in "${beside[@]}"; do kill -- "-$group" 2>/dev/null; done
  wait
  rm -rf "$parts"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# begin LEVEL: a new part; from here on its row is that of a failure, until it has ended.
begin() {
  ((++part))
  from=$SECONDS
  record "$1" 0 1
}

# record LEVEL PASSED FAILED: its row.
record() { printf '%s\t%d\t%d\t%d\n' "$@" $((SECONDS - from)) >"$parts/$part.row"; }

# check LEVEL COMMAND...: a step that counts as one test.
check() {
  local level=$1
  begin "$level"
  shift
  if "$@"; then record "$level" 1 0; else record "$level" 0 1; return 1; fi
}

# tests LEVEL [--within PRESET] COMMAND...: a run of ctest, counted test by test; --within: and by the tests in each program
# of the build that reports them.
tests() {
  local level=$1 account status counts='' programs=() passed failed said
  begin "$level"
  shift
  if [[ $1 == --within ]]; then
    counts=$root/build/$2/counts
    rm -rf "$counts"
    mapfile -t programs < <(ctest --test-dir "build/$2" -N -L '^unit$' -L '^googletest$' | sed -n 's/^ *Test *#[0-9]*: //p')
    shift 2
  fi
  account=$parts/$part.account
  say "tests: $level"
  mkdir -p "$account"
  ACCOUNT=$account "$@" --output-junit "$account/junit.xml" 2>&1 | tee "$account/printed"
  status=${PIPESTATUS[0]}
  said=$(scripts/count-tests --printed "$account/printed" "$account/junit.xml" ${counts:+"$counts" "${programs[@]}"})
  read -r passed failed <<<"${said##*$'\n'}"
  [[ $said != *$'\n'* ]] || printf '%s\n' "${said%$'\n'*}"
  # A failure that is none of a test (ctest's own, the virtual machine's) is one at least.
  ((status == 0 || ${failed:-0} > 0)) || failed=1
  record "$level" "${passed:-0}" "${failed:-1}"
}

# on_can COMMAND...: run_on_can, with what ctest has to tell brought out of the virtual machine.
on_can() { VCAN_VM_OUT=$ACCOUNT run_on_can "$@"; }

# beside COMMAND...: a part that runs while the script goes on; its output comes at the end.
beside() {
  begin "$2"
  set -m  # a process group of its own, which ends with the script
  { ((--part)); "$@"; } >"$parts/$part.output" 2>&1 </dev/null &
  beside+=($!)
  set +m
}

# every_test_has_a_run: whether each test of the release build has a label that is run below. (A unit test that is not
# built has none.)
every_test_has_a_run() {
  local others
  others=$(ctest --test-dir build/release -N -LE '^(unit|optimised|package|web|bus|e2e|master)$' -E '_NOT_BUILT$') || return 1
  grep -q '^Total Tests: 0$' <<<"$others" || { echo "these tests are in no run of ${0##*/}:"; echo "$others"; return 1; }
}

# finish: what ran beside, the table, and the result as exit status.
finish() {
  local output passed failed
  wait
  beside=()
  for output in "$parts"/*.output; do
    [[ ! -e $output ]] || cat "$output"
  done
  echo
  cat "$parts"/*.row | awk -F '\t' '{printf "%-16s %5d passed %5d failed %6d s\n", $1, $2, $3, $4}'
  printf 'in total %d s\n' $((SECONDS - started))
  read -r passed failed < <(cat "$parts"/*.row | awk -F '\t' '{passed += $2; failed += $3} END {print passed + 0, failed + 0}')
  echo "$passed passed, $failed failed"
  exit $((failed > 0))
}

if [[ $quick ]]; then
  check 'build release' build release && tests 'unit release' ctest --preset release -j "$jobs"
  finish
fi

check 'format' scripts/lint.sh --format-only
if check 'build release' build release end_to_end_tests; then
  check 'labels' every_test_has_a_run
  check 'npm packages' need_master
  # They run against the clock on a machine that may give none of them a processor for a while: what fails is run once more,
  # and both runs are told.
  on_a_bus=(ctest --test-dir build/release --output-on-failure --no-tests=error --repeat until-pass:2)
  # Each has a bus of its own, and waits most of the time; slaves in other languages have to answer in time.
  tests 'user-space bus' "${on_a_bus[@]}" -L '^bus$' -j $((2 * jobs))
  # The clock of this machine is not set.
  others=()
  ! have_can || others=(-LE '^clock$')
  # As many side by side as there are processors: the machine of vcan-vm, if it is one, has as many as it may use.
  beside tests 'SocketCAN' on_can "${on_a_bus[@]}" -L '^e2e$' "${others[@]}" -j "$jobs"
  released=yes
  # It has a processor when it wants one: its tests are against time, what follows is not.
  renice -n 19 -p $$ >/dev/null
fi
if check 'build asan' build asan unit_tests; then
  tests 'unit asan' --within asan env GTEST_BRIEF=1 ctest --preset asan -L '^unit$' -j "$jobs"
fi
if [[ ${released:-} ]]; then
  tests 'unit release' ctest --preset release -L '^(optimised|package|web)$' -j "$jobs"
  check 'clang-tidy' scripts/lint.sh --tidy-changed 120
fi
finish
