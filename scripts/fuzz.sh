#!/usr/bin/env bash
# fuzz.sh [--minutes N | --runs N] [--jobs N] [--fast] [--keep]: lets libFuzzer look for inputs that a node handles against its rules.
#
# Builds tests/fuzz with clang (build/fuzz; --fast: build/fuzz-fast, without the sanitizers) and runs it for N minutes (1), or
# for N executions in all, in N processes (all processors), from the kept corpus and the dialogues. Ends with the number of executions, the rate and the
# edges of the library reached. --keep puts what reaches something new into tests/fuzz/corpus, as few and small inputs as
# possible. An input that breaks a rule stays in build/fuzz/findings and makes the exit status 1:
#   build/fuzz/bin/tests/node_replay --trace build/fuzz/findings/crash-...
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

minutes=1 runs='' preset=fuzz keep=''
while (($#)); do
  case $1 in
    --minutes) need_number "$@"; minutes=$2; shift ;;
    --runs) need_number "$@"; runs=$2; shift ;;
    --jobs) need_number "$@"; jobs=$2; shift ;;
    --fast) preset=fuzz-fast ;;
    --keep) keep=yes ;;
    *) misuse "unknown option $1; usage: fuzz.sh [--minutes N | --runs N] [--jobs N] [--fast] [--keep]" ;;
  esac
  shift
done

need_packages clang libclang-rt-14-dev
build "$preset" node_fuzz node_replay
folder=$root/build/$preset
fuzzer=$folder/bin/tests/node_fuzz
corpus=$root/tests/fuzz/corpus
# Short inputs are run more often: most of what a node can do shows within some dozen events.
options=(-max_len=200 -len_control=0 -entropic=0 -timeout=10)

mkdir -p "$folder"/{seeds,found,findings,logs}
rm -f "$folder"/logs/*
"$folder/bin/tests/node_replay" --write "$folder/seeds" "$root/tests/fuzz/dialogues" >/dev/null

if [[ $runs ]]; then
  limit=-runs=$(((runs + jobs - 1) / jobs))
  say "running $runs times in $jobs processes"
else
  limit=-max_total_time=$((minutes * 60))
  say "running for $minutes minutes in $jobs processes"
fi
pids=() status=0
for ((job = 1; job <= jobs; ++job)); do
  "$fuzzer" "${options[@]}" "$limit" -reload=1 -print_final_stats=1 \
    -artifact_prefix="$folder/findings/" "$folder/found" "$corpus" "$folder/seeds" &>"$folder/logs/$job" &
  pids+=($!)
done
trap 'kill "${pids[@]}" 2>/dev/null' INT TERM
for pid in "${pids[@]}"; do wait "$pid" || status=1; done

grep -h -E '^broken:|Assertion|^SUMMARY' "$folder"/logs/* || true
awk '/number_of_executed_units/ {runs += $2} /average_exec_per_sec/ {rate += $2} / cov: / {for (i = 1; i < NF; ++i) if ($i == "cov:" && $(i + 1) > edges) edges = $(i + 1)}
  END {printf "%d executions, %d a second, %d edges of the library\n", runs, rate, edges}' "$folder"/logs/*

if [[ $keep ]]; then
  say "keeping what is new"
  rm -rf "$folder/kept" && mkdir "$folder/kept"
  "$fuzzer" -merge=1 -use_counters=0 -max_len=200 "$folder/kept" "$corpus" "$folder/seeds" "$folder/found" &>"$folder/logs/merge"
  find "$corpus" -type f -delete
  cp "$folder"/kept/* "$corpus"
  echo "$(find "$corpus" -type f | wc -l) inputs, $(du -sb "$corpus" | cut -f 1) bytes"
fi
exit "$status"
