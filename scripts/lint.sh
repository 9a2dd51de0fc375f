#!/usr/bin/env bash
# lint.sh [--format-only | --tidy-only | --tidy-changed [SECONDS]]: checks the form of every source file (clang-format) and looks for
# faults in those of the product (clang-tidy; headers that are generated are those of build/release). Changes nothing; ends with 1
# on a finding.
#
# --tidy-changed: clang-tidy over the files that the last commit changed, or that were changed since, those with the most
# changes first. With SECONDS none is begun after that time, and how many were left out is said. All of the tree take two
# hours on two processors; the analyser alone, which is one of clang-tidy's checks, is quicker by `analyse`.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"
cd "$root"

# sources PATTERN...: the files of the tree that match, known to git or not yet, without what is ignored.
sources() {
  if git rev-parse --is-inside-work-tree &>/dev/null; then
    git ls-files --cached --others --exclude-standard --deduplicate -- "$@" | while read -r file; do
      [[ ! -e $file ]] || echo "$file"  # deleted, but not yet committed
    done
  else
    local names=() pattern
    for pattern in "$@"; do names+=(-o -name "$pattern"); done
    find . -path ./build -prune -o -type f \( "${names[@]:1}" \) -print | sed 's,^\./,,'
  fi
}

check_format() {
  local files
  mapfile -t files < <(sources '*.cpp' '*.hpp' '*.c' '*.h')
  ((${#files[@]})) || return 0
  say "clang-format: ${#files[@]} files"
  printf '%s\0' "${files[@]}" | xargs -0 -n 16 -P "$jobs" clang-format --dry-run -Werror
}

# changed: the sources that the last commit changed, and those that were changed since; most changes first.
changed() {
  git rev-parse --verify --quiet HEAD~1 >/dev/null || return 0
  git ls-files --others --exclude-standard -- '*.cpp'
  git diff --numstat --no-renames --diff-filter=d HEAD~1 -- '*.cpp' | sort -k 1,1nr | cut -f 3
}

# tidy FILE: one of them, unless the time is over; then its name is added to $left_out.
tidy() {
  [[ -z $last_start || $EPOCHSECONDS -lt $last_start ]] || { echo "$1" >>"$left_out"; return 0; }
  # g++ alone knows some of the warning options in the compile commands.
  clang-tidy -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option "$1"
}

# compile_each_alone: the compile commands of a release build that compiles each source by itself and takes generated headers
# from build/release: build/tidy, which is configured and never built.
compile_each_alone() {
  [[ -e build/release/CMakeCache.txt ]] || die "build/release is not configured: cmake --preset release"
  cmake --preset release -B build/tidy -DAXISD_FAST_COMPILE=OFF >/dev/null || die "build/tidy cannot be configured"
  sed -i "s,$root/build/tidy,$root/build/release,g" build/tidy/compile_commands.json
}

# check_tidy SECONDS COMMAND...: over the files that it prints; SECONDS may be empty.
check_tidy() {
  local files status=0 last_start=${1:+$((EPOCHSECONDS + $1))} left_out
  shift
  mapfile -t files < <("$@" | grep -Ev '^(tests|bench)/')
  ((${#files[@]})) || return 0
  compile_each_alone
  # Tests and benchmarks are left out: GoogleTest's macros would need more exceptions than checks remain. A source without
  # a compile command (another operating system's, or a program built elsewhere) cannot be checked.
  mapfile -t files < <(printf '%s\n' "${files[@]}" | while read -r file; do
    grep -qF "\"file\": \"$root/$file\"" build/tidy/compile_commands.json && echo "$file"
  done)
  ((${#files[@]})) || return 0
  say "clang-tidy: ${#files[@]} files"
  left_out=$(mktemp)
  export -f tidy
  export last_start left_out
  printf '%s\0' "${files[@]}" | xargs -0 -I FILE -P "$jobs" bash -c 'tidy "$1"' tidy FILE \
    2> >(grep -v 'warnings generated\|^Suppressed\|^Use -header-filter' >&2) || status=1
  [[ ! -s $left_out ]] || say "clang-tidy: no time for $(wc -l <"$left_out") of these; ${0##*/} --tidy-only checks all of the tree"
  rm -f "$left_out"
  return $status
}

case ${1:-} in
  --format-only) check_format ;;
  --tidy-only) check_tidy '' sources '*.cpp' ;;
  --tidy-changed)
    [[ $# == 1 ]] || need_number "$1" "$2"
    check_tidy "${2:-}" changed ;;
  '') check_format && check_tidy '' sources '*.cpp' ;;
  *) misuse "unknown option $1; usage: lint.sh [--format-only | --tidy-only | --tidy-changed [SECONDS]]" ;;
esac
