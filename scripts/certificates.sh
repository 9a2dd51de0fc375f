#!/usr/bin/env bash
# certificates.sh [--seeds N]: what a release is held against, and what came of it: axisd with 1, 2 and 8 axes of both profiles before
# canopen-check, with its EDS and with leave to move the drives and to save, and the worlds of N seeds (1000) of axisd-sim.
#
# Builds what it needs (build/release). Reports are in build/certificates/*.json; rows of their sums are printed. The buses have a
# time of their own, so that a slow machine is no finding. The exit status is 1 if a check failed or an invariant was broken.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

seeds=1000
while (($#)); do
  case $1 in
    --seeds) need_number "$@"; seeds=$2; shift ;;
    *) misuse "unknown option $1; usage: certificates.sh [--seeds N]" ;;
  esac
  shift
done

build release axisd canopen-check with-can can-preload canhub compiled_catalogue compiled_deviations
folder=$root/build/certificates bin=$root/build/release/bin eds=$root/build/release/share/axisd/eds
rm -rf "$folder"
mkdir -p "$folder"

# check PROFILE AXES NAME: canopen-check of such a unit; its EDS is NAME.eds, or NAME-AXES-axes.eds. Two programs on a bus of their own.
check() {
  local file=$eds/$3.eds options=()
  (($2 == 1)) || file=$eds/$3-$2-axes.eds
  [[ $1 != s120 ]] || options=(--deviations "$eds/axisd-deviations.json")
  python3 -c 'import json, sys; print(json.dumps({"profile": sys.argv[1], "node_id": 5, "axes": [{}] * int(sys.argv[2])}))' "$1" "$2" \
    >"$folder/unit"
  "$bin/with-can" --private --time virtual -- bash -c '
    "$1/axisd" --interface "unix:$CAN_BUS" --config "$2/unit" --state-directory "$2/state" --control "$2/control" 2>/dev/null &
    unit=$! status=0
    "$1/canopen-check" --interface "unix:$CAN_BUS" --node 5 --allow-motion --allow-store --json "$3" --eds "${@:4}" >/dev/null || status=$?
    kill "$unit"
    wait "$unit"
    exit "$status"' check "$bin" "$folder" "$folder/$1-$2.json" "$file" "${options[@]}" || status=1
  rm -rf "$folder"/{unit,state,control}
}

status=0
for axes in 1 2 8; do
  check s120 "$axes" axisd
  check cia402 "$axes" axisd-cia402
done
python3 - "$folder"/*.json <<'EOF'
import collections, json, os, sys
print('| device | passed | known deviations | failed | not for it |\n|---|---|---|---|---|')
for path in sys.argv[1:]:
    profile, axes = os.path.splitext(os.path.basename(path))[0].split('-')
    counts = collections.Counter(result['outcome'] for result in json.load(open(path))['results'])
    failed = sum(counts.values()) - sum(counts[each] for each in ('passed', 'deviation', 'skipped'))
    print(f"| {profile}, axes: {axes} | {counts['passed']} | {counts['deviation']} | {failed} | {counts['skipped']} |")
EOF
"$root/scripts/sim.sh" --seeds "$seeds" || status=1
exit "$status"
