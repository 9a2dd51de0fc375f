#!/usr/bin/env bash
# check_installation.sh CHECK: installs the whole project from the build tree to a temporary prefix and checks one thing of
# it. SOURCE_DIR, BUILD_DIR, BUILD_TYPE and CMAKE name the tree, its build and its type, and cmake.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

fail() { echo "$*" >&2; exit 1; }

install_all() { "$CMAKE" --install "$BUILD_DIR" --prefix "$prefix" >"$work/log" 2>&1 || fail "$(<"$work/log")"; }

# links_of PAGE: the files that a Markdown page points to, without what stands in blocks of code.
links_of() {
  sed '/^```/,/^```/d;/^    /d' "$1" | grep -oE '\]\([^) ]+\)' | sed -E 's/^\]\(//;s/\)$//;s/#.*//' | grep -vE '^([a-z]+:|$)'
}

check_links() {
  local page link count=0 missing=
  install_all
  while read -r page; do
    while read -r link; do
      ((count += 1))
      [[ -e ${page%/*}/$link ]] || missing+="${page#"$prefix"/} points to $link"$'\n'
    done < <(links_of "$page")
  done < <(find "$prefix/share/doc/axisd" -name '*.md')
  [[ ! $missing ]] || fail "$missing"
  ((count > 100)) || fail "only $count links were found"
}

# says PATTERN COMMAND...: whether the output of COMMAND, read to its end, has a line that matches.
says() {
  local pattern=$1 output
  shift
  output=$("$@")
  grep -qE "$pattern" <<<"$output"
}

check_hardened() {
  local file
  install_all
  for file in "$prefix"/bin/* "$prefix"/lib/axisd/*.so "$prefix"/lib/libcanopen.so; do
    says ' Type: +DYN' readelf -Wh "$file" || fail "$file: is not position independent"
    says 'BIND_NOW|Flags:.* NOW' readelf -Wd "$file" || fail "$file: binds addresses when they are used"
    says 'GNU_RELRO' readelf -Wl "$file" || fail "$file: has no RELRO"
    says 'GNU_STACK .* RW ' readelf -Wl "$file" || fail "$file: has a stack that can be run"
    says '__stack_chk_fail' readelf -Ws --dyn-syms "$file" || fail "$file: does not watch its stack"
  done
  [[ $(uname -m) != x86_64 ]] || says 'endbr64' objdump -d "$prefix/bin/axisd" || fail "axisd: does not mark where calls may go"
  [[ $BUILD_TYPE == Release ]] || return 0
  for file in axisd canhub; do
    says '__[a-z]+_chk@' readelf -Ws --dyn-syms "$prefix/bin/$file" || fail "$file: has no checked calls of libc"
  done
}

# Configured and not built: as after a demo, which builds what it needs and no more.
check_half_built() {
  local answer
  "$CMAKE" -S "$SOURCE_DIR" -B "$work/build" -G Ninja -DAXISD_TESTS=OFF -DAXISD_BENCH=OFF >"$work/log" 2>&1 || fail "$(<"$work/log")"
  if answer=$("$CMAKE" --install "$work/build" --prefix "$prefix" 2>&1); then fail "it was installed"; fi
  answer=$(tr -s ' \n' ' ' <<<"$answer")  # CMake breaks lines
  [[ $answer == *"bin/axisd has not been built, nothing was installed"* ]] || fail "$answer"
  [[ $answer == *"cmake --build $work/build --target installed"* ]] || fail "$answer"
  [[ ! -e $prefix ]] || fail "something was installed: $(find "$prefix")"
}

"check_$1"
