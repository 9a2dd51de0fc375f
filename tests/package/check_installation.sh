#!/usr/bin/env bash
# check_installation.sh CHECK: installs the whole project from the build tree to a temporary prefix and checks one thing of
# it. SOURCE_DIR, BUILD_DIR, BUILD_TYPE, CMAKE and CXX name the tree, its build and its type, cmake, and the compiler.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

fail() { echo "$*" >&2; exit 1; }

install_all() { "$CMAKE" --install "$BUILD_DIR" --prefix "$prefix" >"$work/log" 2>&1 || fail "$(<"$work/log")"; }

# Files and headings that pages point to; every page of docs/ from the index.
check_links() {
  install_all
  PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$SOURCE_DIR/tests/docs/check_links.py" "$prefix/share/doc/axisd" docs/README.md
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
    if says 'RPATH|RUNPATH' readelf -Wd "$file"; then fail "$file: looks for libraries in folders of its own"; fi
    says '__stack_chk_fail' readelf -Ws --dyn-syms "$file" || fail "$file: does not watch its stack"
  done
  [[ $(uname -m) != x86_64 ]] || says 'endbr64' objdump -d "$prefix/bin/axisd" || fail "axisd: does not mark where calls may go"
  [[ $BUILD_TYPE == Release ]] || return 0
  # libcanopen calls none of the functions in question.
  for file in "$prefix"/bin/* "$prefix"/lib/axisd/*.so; do
    says '__[a-z]+_chk@' readelf -Ws --dyn-syms "$file" || fail "$file: has no checked calls of libc"
  done
}

# Every program says one version, that of the project, and one commit, if any.
check_versions() {
  local program lines version
  version=$(sed -n 's/^project(axisd VERSION \([0-9.]*\).*/\1/p' "$SOURCE_DIR/CMakeLists.txt")
  install_all
  lines=$(for program in "$prefix"/bin/*; do "$program" --version | sed "s/^${program##*/} //"; done | sort -u)
  [[ $lines =~ ^"$version"(\ \([0-9a-f]{10}(-dirty)?\))?$ ]] || fail "expected one version $version and one commit, got: $lines"
}

# page_of NAME: the text of the man page, as it is shown, in one line without hyphenation.
page_of() {
  local page
  page=$(find "$prefix/share/man" -name "$1.[0-9].gz")
  [[ $page && $page != *$'\n'* ]] || fail "$1: expected one man page, got '$page'"
  gzip -dc "$page"
}

# plain_page_of NAME: without the marks of roff.
plain_page_of() { page_of "$1" | sed -e 's/\\f[A-Z]//g' -e 's/\\&//g' -e 's/\\\(.\)/\1/g'; }

check_man() {
  local program page option key count=0 name
  install_all
  for program in "$prefix"/bin/*; do
    page=$(plain_page_of "${program##*/}")
    while read -r option; do
      ((count += 1))
      grep -qE -- "(^|[ ,])$option($|[ ,])" <<<"$page" || fail "${program##*/}: its man page does not have $option"
    done < <("$program" --help | grep -oE '^ +(-[a-zA-Z], ?)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+')
    for name in NAME SYNOPSIS DESCRIPTION OPTIONS 'EXIT STATUS' EXAMPLES 'SEE ALSO'; do
      grep -qE "^\.SH \"?$name\"?$" <<<"$page" || fail "${program##*/}: its man page has no section $name"
    done
  done
  ((count > 40)) || fail "only $count options were found"
  grep -qF -- '--ignore CHECK[:SECTION]' <<<"$(plain_page_of edstool)" || fail "edstool: the value of --ignore is not as in its help"
  page=$(plain_page_of axisd.json)
  count=0
  while read -r key; do
    ((count += 1))
    grep -qE "(^|\.)$key$" <<<"$page" || fail "axisd.json(5) does not have the key $key"
  done < <(python3 - "$SOURCE_DIR/daemon/axisd.schema.json" <<'KEYS'
import json, sys

def keys(node):
    if isinstance(node, dict):
        for name, value in node.items():
            if name == "properties":
                yield from value
            yield from keys(value)
    elif isinstance(node, list):
        for value in node:
            yield from keys(value)

definitions = json.load(open(sys.argv[1]))["$defs"]
print(*sorted({key for name in definitions for key in keys(definitions[name])}), sep="\n")
KEYS
)
  ((count > 80)) || fail "only $count keys were found"
  # Pages of our own that others point to.
  while read -r name; do
    page_of "$name" >/dev/null
  done < <(find "$prefix/share/man" -name '*.gz' -exec gzip -dc {} + | sed 's/\\f[A-Z]//g' |
    grep -oE '(axisd|axisctl|axisd-sim|axisd\.json|axisd-http|axisd-nats|axisd-agent|canhub|canrec|with-can|canopen-audit|canopen-check|canopen-zoo|edstool)\([158]\)' | sed 's/(.*//' | sort -u)
}

# The installed program knows the installed scenarios by their names, runs them with the installed programs, and says their schema.
check_scenarios() {
  local said listed name
  install_all
  cd "$work"
  listed=$(env PATH=/usr/bin:/bin "$prefix/bin/axisctl" run --list)
  for name in "$SOURCE_DIR"/scenarios/*.json; do
    name=${name##*/}
    grep -qE "^${name%.json}( |$)" <<<"$listed" || fail "${name%.json} is not in the list: $listed"
  done
  name=boot-up-missing
  said=$(env PATH=/usr/bin:/bin "$prefix/bin/axisctl" run "$name") || fail "$name: $said"
  "$prefix/bin/axisctl" run --schema | cmp - "$prefix/share/axisd/axisd-scenario.schema.json" || fail "another schema is installed"
}

# What tests of others are made of: each starts the unit that is installed beside it, and nothing of the tree.
check_fixtures() {
  local said modules
  install_all
  modules=$(echo "$prefix"/lib/python3*/dist-packages)
  cd "$work"
  said=$(env -u AXISD_BIN_DIR PATH=/usr/bin:/bin PYTHONPATH="$modules" /usr/bin/python3 -c 'import axisd
with axisd.Unit() as unit:
    print(unit.bus.recv(), unit.bus.hub.process.args[0], unit._program.process.args[0])')
  [[ $said == "705#00 $prefix/bin/canhub $prefix/bin/axisd" ]] || fail "the module of Python says: $said"
  cat >"$work/test_one.py" <<'TEST'
def test_one(drive):
    assert str(drive.bus.recv()) == "705#00"
TEST
  said=$(env -u AXISD_BIN_DIR PATH=/usr/bin:/bin PYTHONPATH="$modules" /usr/bin/python3 -m pytest -q -p no:cacheprovider "$work/test_one.py")
  [[ $said == *'1 passed'* ]] || fail "pytest says: $said"
  # shellcheck disable=SC2016  # of JavaScript
  said=$(env -u AXISD_BIN_DIR PATH="$prefix/bin:$PATH" NODE_PATH="$prefix/share/nodejs" node -e 'require("axisd").Unit.start().then(async (unit) => {
    console.log(`${unit.bus.frames}`);
    await unit.close();
  })')
  [[ $said == '705#00' ]] || fail "the module of Node says: $said"
  cat >"$work/one.cpp" <<'PROGRAM'
#include <iostream>

#include <axisd/testing.hpp>

int main() {
  axisd::testing::Unit unit;
  std::cout << unit.wait_frame(0x705).text() << std::endl;
}
PROGRAM
  "$CXX" -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror -I "$prefix/include" -o "$work/one" "$work/one.cpp" -lgtest -pthread
  said=$(env -u AXISD_BIN_DIR PATH="$prefix/bin:$PATH" "$work/one")
  [[ $said == '705#00' ]] || fail "the header of C++ says: $said"
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
