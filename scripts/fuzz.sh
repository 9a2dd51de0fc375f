#!/usr/bin/env bash
# fuzz.sh [--minutes N | --runs N] [--jobs N] [--fast] [--keep]: lets libFuzzer look for inputs that a node handles against its rules.
# fuzz.sh --eds [--minutes N | --runs N] [--jobs N] [--fast]: likewise texts that the reader of EDS files handles against its rules.
# fuzz.sh --records [--minutes N | --runs N] [--jobs N] [--fast] [--keep]: likewise records and parameter channels of PROFIdrive that a unit answers against the rules.
# fuzz.sh --reader NAME [--minutes N | --runs N] [--jobs N] [--fast]: likewise inputs for one of the readers of tests/fuzz/readers.
# fuzz.sh --modbus [--minutes N | --runs N] [--jobs N] [--fast]: likewise streams of Modbus TCP that a unit answers against the rules.
#
# Builds tests/fuzz with clang (build/fuzz; --fast: build/fuzz-fast, without the sanitizers) and runs it for N minutes (1), or
# for N executions in all, in N processes (all processors), from the kept corpus and the dialogues. Ends with the number of executions, the rate and the
# edges of the library reached. --keep puts what reaches something new into tests/fuzz/corpus, as few and small inputs as
# possible (--records: into tests/fuzz/records/corpus). An input that breaks a rule stays in build/fuzz/findings and makes the exit status 1:
#   build/fuzz/bin/tests/node_replay --trace build/fuzz/findings/crash-...
# Records start from their kept inputs; one that breaks a rule is played again by build/fuzz/bin/tests/records_fuzz FILE.
# Streams of Modbus TCP start from tests/data/modbus, where a test plays them; build/fuzz/bin/tests/modbus_fuzz FILE plays one again.
# Readers start from what tests/fuzz/readers has for them; FUZZ_READER=NAME build/fuzz/bin/tests/readers_fuzz FILE reads one again.
# Texts start from tests/data/eds; one that breaks a rule is read again by build/fuzz/bin/tests/eds_fuzz FILE.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

minutes=1 runs='' preset=fuzz keep='' target=node
while (($#)); do
  case $1 in
    --minutes) need_number "$@"; minutes=$2; shift ;;
    --runs) need_number "$@"; runs=$2; shift ;;
    --jobs) need_number "$@"; jobs=$2; shift ;;
    --fast) preset=fuzz-fast ;;
    --keep) keep=yes ;;
    --eds) target=eds ;;
    --records) target=records ;;
    --modbus) target=modbus ;;
    --reader) [[ ${2:-} ]] || misuse "--reader needs a name"; target=readers; FUZZ_READER=$2; export FUZZ_READER; shift ;;
    *) misuse "unknown option $1; usage: fuzz.sh [--eds | --records | --modbus | --reader NAME] [--minutes N | --runs N] [--jobs N] [--fast] [--keep]" ;;
  esac
  shift
done
case $target in
  eds | modbus) [[ ! $keep ]] || misuse "--keep is not for texts and streams of Modbus TCP; one that shows something new goes into tests/data/$target" ;;
  readers) [[ ! $keep ]] || misuse "--keep is not for readers; an input that shows something new becomes one of those that a reader begins with" ;;
esac

need_packages clang libclang-rt-14-dev
folder=$root/build/$preset
mkdir -p "$folder"/{seeds,found,found-eds,found-records,found-modbus,findings,logs}
rm -f "$folder"/logs/*
fuzzer=$folder/bin/tests/${target}_fuzz
if [[ $target == eds ]]; then
  build "$preset" eds_fuzz
  inputs=("$folder/found-eds" "$root/tests/data/eds")
  options=(-max_len=8192 -timeout=10)
elif [[ $target == modbus ]]; then
  build "$preset" modbus_fuzz
  inputs=("$folder/found-modbus" "$root/tests/data/modbus")
  options=(-max_len=1500 -timeout=10)
elif [[ $target == readers ]]; then
  build "$preset" readers_fuzz write_inputs
  mkdir -p "$folder"/{seeds,found}-"$FUZZ_READER"
  "$folder/bin/tests/write_inputs" "$FUZZ_READER" "$folder/seeds-$FUZZ_READER" || exit 2
  inputs=("$folder/found-$FUZZ_READER" "$folder/seeds-$FUZZ_READER")
  options=(-max_len=8192 -timeout=10 -rss_limit_mb=4096)
elif [[ $target == records ]]; then
  build "$preset" records_fuzz
  corpus=$root/tests/fuzz/records/corpus
  inputs=("$folder/found-records" "$corpus")
  options=(-max_len=500 -timeout=10)
else
  build "$preset" node_fuzz node_replay
  corpus=$root/tests/fuzz/corpus
  inputs=("$folder/found" "$corpus" "$folder/seeds")
  # Short inputs are run more often: most of what a node can do shows within some dozen events.
  options=(-max_len=200 -len_control=0 -entropic=0 -timeout=10)
  "$folder/bin/tests/node_replay" --write "$folder/seeds" "$root/tests/fuzz/dialogues" >/dev/null
fi

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
    -artifact_prefix="$folder/findings/" "${inputs[@]}" &>"$folder/logs/$job" &
  pids+=($!)
done
trap 'kill "${pids[@]}" 2>/dev/null' INT TERM
for pid in "${pids[@]}"; do wait "$pid" || status=1; done

grep -h -E '^broken:|Assertion|^SUMMARY' "$folder"/logs/* || true
awk '/number_of_executed_units/ {runs += $2} /average_exec_per_sec/ {rate += $2} / cov: / {for (i = 1; i < NF; ++i) if ($i == "cov:" && $(i + 1) > edges) edges = $(i + 1)}
  END {printf "%d executions, %d a second, %d edges of the code\n", runs, rate, edges}' "$folder"/logs/*

if [[ $keep ]]; then
  say "keeping what is new"
  rm -rf "$folder/kept" && mkdir "$folder/kept"
  "$fuzzer" -merge=1 -use_counters=0 "${options[0]}" "$folder/kept" "${inputs[@]}" &>"$folder/logs/merge"
  find "$corpus" -type f -delete
  cp "$folder"/kept/* "$corpus"
  echo "$(find "$corpus" -type f | wc -l) inputs, $(du -sb "$corpus" | cut -f 1) bytes"
fi
exit "$status"
