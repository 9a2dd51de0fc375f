#!/usr/bin/env bash
# coverage.sh [--lines]: which lines of libcanopen the unit tests and the kept inputs of the fuzzer reach.
#
# Builds with clang in build/coverage, runs canopen_test, canopen_allocation_test and node_replay, and prints a table with a
# row a file. --lines lists the lines that nothing reached. The exit status is 1 if less than 95 % of all lines are reached.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"
readonly least=95
cd "$root"

lines=''
case ${1:-} in
  '') ;;
  --lines) lines=yes ;;
  *) misuse "unknown option $1; usage: coverage.sh [--lines]" ;;
esac

need_packages clang llvm-14
build coverage canopen_test canopen_allocation_test node_replay
folder=$root/build/coverage
bin=$folder/bin/tests
rm -f "$folder"/*.profraw
LLVM_PROFILE_FILE=$folder/unit.profraw "$bin/canopen_test" --gtest_brief=1
LLVM_PROFILE_FILE=$folder/allocation.profraw "$bin/canopen_allocation_test" --gtest_brief=1
LLVM_PROFILE_FILE=$folder/corpus.profraw "$bin/node_replay" tests/fuzz/dialogues tests/fuzz/corpus | tail -1
llvm-profdata-14 merge -o "$folder/all.profdata" "$folder"/*.profraw

objects=("$bin/canopen_test" -object "$bin/canopen_allocation_test" -object "$bin/node_replay")
of_library=(-instr-profile "$folder/all.profdata" -ignore-filename-regex '/(tests|usr)/')
llvm-cov-14 report "${objects[@]}" "${of_library[@]}" -show-region-summary=0 -show-branch-summary=0 |
  awk 'NF == 7 && $NF ~ /%$/ {printf "%-32s %5d of %5d lines %8s\n", $1, $5 - $6, $5, $7}' | tee "$folder/table"
if [[ $lines ]]; then
  llvm-cov-14 show "${objects[@]}" "${of_library[@]}" | awk '/^\/.*:$/ {file = $0} /^ *[0-9]+\| +0\|/ {print file $0}'
fi
awk -v least="$least" '$1 == "TOTAL" {reached = $NF + 0} END {exit reached < least}' "$folder/table" ||
  die "less than $least % of the lines are reached"
