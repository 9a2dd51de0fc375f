#!/usr/bin/env bash
# coverage.sh [--all] [--lines]: which lines of libcanopen the unit tests and the kept inputs of the fuzzer reach; with --all
# which lines and branches of the whole product all tests of the user-space bus and all unit tests reach.
#
# Builds with clang in build/coverage. Without --all runs canopen_test, canopen_allocation_test and node_replay, and prints a row a
# file; with --all runs ctest, and prints a row a folder. --lines lists the lines that nothing reached; with --all they are in
# build/coverage/unreached anyway. The exit status is 1 if less than 95 % of all lines of libcanopen are reached, and with --all if a branch
# of the state machines (scripts/coverage-report) is not.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"
readonly least=95
cd "$root"

all='' lines=''
while (($#)); do
  case $1 in
    --all) all=yes ;;
    --lines) lines=yes ;;
    *) misuse "unknown option $1; usage: coverage.sh [--all] [--lines]" ;;
  esac
  shift
done

folder=$root/build/coverage
bin=$folder/bin/tests

# of_library: the table of libcanopen.
of_library() {
  build coverage canopen_test canopen_allocation_test node_replay
  rm -f "$folder"/*.profraw
  LLVM_PROFILE_FILE=$folder/unit.profraw "$bin/canopen_test" --gtest_brief=1
  LLVM_PROFILE_FILE=$folder/allocation.profraw "$bin/canopen_allocation_test" --gtest_brief=1
  LLVM_PROFILE_FILE=$folder/corpus.profraw "$bin/node_replay" tests/fuzz/dialogues tests/fuzz/corpus | tail -1
  llvm-profdata-14 merge -o "$folder/all.profdata" "$folder"/*.profraw
  local objects=("$bin/canopen_test" -object "$bin/canopen_allocation_test" -object "$bin/node_replay")
  local of_library=(-instr-profile "$folder/all.profdata" -ignore-filename-regex '/(tests|usr)/')
  llvm-cov-14 report "${objects[@]}" "${of_library[@]}" -show-region-summary=0 -show-branch-summary=0 |
    awk 'NF == 7 && $NF ~ /%$/ {printf "%-32s %5d of %5d lines %8s\n", $1, $5 - $6, $5, $7}' | tee "$folder/table"
  if [[ $lines ]]; then
    llvm-cov-14 show "${objects[@]}" "${of_library[@]}" | awk '/^\/.*:$/ {file = $0} /^ *[0-9]+\| +0\|/ {print file $0}'
  fi
  awk -v least="$least" '$1 == "TOTAL" {reached = $NF + 0} END {exit reached < least}' "$folder/table" ||
    die "less than $least % of the lines are reached"
}

# of_product: the table of all folders. Tests end their programs instead of killing them, which leaves no counts.
of_product() {
  build coverage all
  need_master
  rm -rf "$folder/raw"
  ctest --test-dir "$folder" -L '^unit$' -j "$jobs" >"$folder/unit.log" || true
  COUNT_COVERAGE=yes ctest --test-dir "$folder" -L '^bus$' -j $((2 * jobs)) >"$folder/bus.log" || true
  grep 'tests passed' "$folder/unit.log" "$folder/bus.log" | sed 's,.*/,,'
  llvm-profdata-14 merge -sparse -o "$folder/all.profdata" "$folder/raw"
  local objects=()
  mapfile -t objects < <(find "$bin" "${bin%/tests}" -maxdepth 1 -type f -executable -printf '-object\n%p\n')
  # Sources are named from the folder of the build on: build/ is part of every name.
  llvm-cov-14 export -format=lcov -instr-profile "$folder/all.profdata" -ignore-filename-regex '/(tests|usr|bench)/' \
    "${objects[@]:1}" >"$folder/lcov" 2>"$folder/export.log"
  scripts/coverage-report "$root" "$folder/lcov" "$folder/unreached"
  [[ ! $lines ]] || cat "$folder/unreached"
}

need_packages clang llvm-14
if [[ $all ]]; then of_product; else of_library; fi
