#!/usr/bin/env bash
# lint.sh [--format-only | --tidy-only | --tidy-changed]: checks the form of every source file (clang-format) and looks for
# faults in those of the product (clang-tidy, with the compile commands of build/release). Changes nothing; ends with 1 on a
# finding.
#
# --tidy-changed: clang-tidy over the files that the last commit changed, or that were changed since. All of them take half an
# hour on two processors.
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

# changed: the sources that the last commit changed, and those that were changed since.
changed() {
  git rev-parse --verify --quiet HEAD~1 >/dev/null || return 0
  { git diff --name-only --diff-filter=d HEAD~1 -- '*.cpp'; git ls-files --others --exclude-standard -- '*.cpp'; } | sort -u
}

# check_tidy COMMAND...: over the files that it prints.
check_tidy() {
  local files
  [[ -e build/release/compile_commands.json ]] || die "build/release is not configured: cmake --preset release"
  # Tests and benchmarks are left out: GoogleTest's macros would need more exceptions than checks remain. A source without
  # a compile command (another operating system's, or a program built elsewhere) cannot be checked.
  mapfile -t files < <("$@" | grep -Ev '^(tests|bench)/' | while read -r file; do
    grep -qF "\"file\": \"$root/$file\"" build/release/compile_commands.json && echo "$file"
  done)
  ((${#files[@]})) || return 0
  say "clang-tidy: ${#files[@]} files"
  # g++ alone knows some of the warning options in the compile commands.
  printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$jobs" \
    clang-tidy -p build/release --quiet --extra-arg=-Wno-unknown-warning-option 2> >(grep -v 'warnings generated\|^Suppressed\|^Use -header-filter' >&2)
}

case ${1:-} in
  --format-only) check_format ;;
  --tidy-only) check_tidy sources '*.cpp' ;;
  --tidy-changed) check_tidy changed ;;
  '') check_format && check_tidy sources '*.cpp' ;;
  *) misuse "unknown option $1; usage: lint.sh [--format-only | --tidy-only | --tidy-changed]" ;;
esac
