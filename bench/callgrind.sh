#!/usr/bin/env bash
# callgrind.sh [--build DIR] [--times N] [OPERATION...]: instructions of each operation, as a Markdown table.
#
# Every operation runs N times (20000) and 2 N times under callgrind; the difference divided by N is one operation, without
# start and set-up. The counts are exact: they repeat on every machine that has the same program.
#
# --build DIR  the build with the programs (build/release, built first if it is this one)
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/../scripts/common.sh"
cd "$root"

build=build/release times=20000
while (($#)); do
  case $1 in
    --build) build=${2:-}; [[ $build ]] || misuse "--build needs a folder"; shift 2 ;;
    --times) need_number "$@"; times=$2; shift 2 ;;
    -*) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0" >&2; exit 2 ;;
    *) break ;;
  esac
done
command -v valgrind >/dev/null || { echo "${0##*/}: missing Debian package: apt-get install valgrind" >&2; exit 2; }
if [[ $build == build/release ]]; then
  cmake --preset release >/dev/null
  cmake --build --preset release --target instruction_count >/dev/null
fi
driver=$build/bin/instruction_count
[[ -x $driver ]] || { echo "${0##*/}: $driver does not exist" >&2; exit 2; }

# instructions OPERATION N: of the whole program.
instructions() {
  local answer
  answer=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$driver" "$1" "$2" 2>&1) ||
    { echo "$answer" >&2; return 1; }
  sed -n 's/^==[0-9]*== Collected : \([0-9]*\).*/\1/p' <<<"$answer"
}

echo '| operation | instructions |  |'
echo '|---|---:|---|'
"$driver" --list | while IFS=$'\t' read -r name text; do
  (($# == 0)) || [[ " $* " == *" $name "* ]] || continue
  once=$(instructions "$name" "$times")
  twice=$(instructions "$name" $((2 * times)))
  printf '| `%s` | %s | %s |\n' "$name" "$(((twice - once + times / 2) / times))" "$text"
done
