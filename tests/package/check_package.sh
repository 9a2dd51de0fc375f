#!/usr/bin/env bash
# check_package.sh CHECK: installs libcanopen from the build tree to a temporary prefix and checks one thing of it, as a
# user would meet it. SOURCE_DIR, BUILD_DIR, CXX and CMAKE name the tree, its build, the compiler and cmake.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig

fail() { echo "$*" >&2; exit 1; }

install_package() {
  "$CMAKE" --install "$BUILD_DIR" --component libcanopen --prefix "$prefix" >"$work/log" || fail "$(<"$work/log")"
}

# build SOURCE BUILD [OPTION]...: configures and builds a CMake project.
build() {
  local source=$1 build=$2
  shift 2
  "$CMAKE" -S "$source" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$CXX" "$@" && "$CMAKE" --build "$build" -j 2
}

# expect_usage PROGRAM: it starts, so it has found its libraries, and says how it wants to be called.
expect_usage() {
  local answer status=0
  answer=$("$@" 2>&1) || status=$?
  [[ $status == 2 && $answer == usage:* ]] || fail "$1 ended with $status: $answer"
}

# Copied out of the tree, so that nothing but the package can be found.
copy_examples() { cp -r "$SOURCE_DIR/examples" "$work/examples"; }

check_cmake() {
  copy_examples
  build "$work/examples" "$work/build" -DCMAKE_PREFIX_PATH="$prefix"
  expect_usage "$work/build/example_slave"
  sed -i 's/libcanopen::libcanopen/libcanopen::libcanopen-static/' "$work/examples/CMakeLists.txt"
  build "$work/examples" "$work/static" -DCMAKE_PREFIX_PATH="$prefix"
  rm "$prefix"/lib/libcanopen.so*
  expect_usage "$work/static/example_slave"
}

check_pkg_config() {
  local flags
  copy_examples
  mv "$prefix" "$work/moved"  # whatever the package says of itself must hold wherever it lies
  export PKG_CONFIG_PATH=$work/moved/lib/pkgconfig
  read -ra flags < <(pkg-config --cflags --libs libcanopen)
  "$CXX" -std=c++20 -Wall -Wextra -Werror -o "$work/example_slave" "$work/examples/example_slave.cpp" "${flags[@]}"
  LD_LIBRARY_PATH=$work/moved/lib expect_usage "$work/example_slave"
}

check_soname() {
  local version soname
  version=$(pkg-config --modversion libcanopen)
  soname=$(readelf -d "$prefix/lib/libcanopen.so" | sed -n 's/.*Library soname: \[\(.*\)\]/\1/p')
  [[ $soname == "libcanopen.so.${version%%.*}" ]] || fail "soname '$soname' of version $version"
  [[ $(readlink -f "$prefix/lib/$soname") == "$(readlink -f "$prefix/lib")/libcanopen.so.$version" ]] ||
    fail "$soname is not libcanopen.so.$version"
}

# Everything is of canopen, except what templates of the standard library leave weak.
check_symbols() {
  local all foreign
  all=$(nm -DC --defined-only "$prefix/lib/libcanopen.so" | cut -d' ' -f2-)
  grep -q '^T canopen::Node::on_frame(' <<<"$all" || fail "Node::on_frame is not exported: $all"
  foreign=$(grep -vE '^[A-Za-z] ((vtable|typeinfo|typeinfo name|VTT) for |(non-)?virtual thunk to )?canopen::' <<<"$all" |
    grep -vE '^[VWu] .*\bstd::') || true
  [[ -z $foreign ]] || fail "exported, but not of the library:"$'\n'"$foreign"
}

# The standard library is all it needs.
check_needs() {
  local needed
  needed=$(readelf -d "$prefix/lib/libcanopen.so" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
    grep -vE '^(libstdc\+\+|libgcc_s|libm|libc)\.so' ) || true
  [[ -z $needed ]] || fail "the library needs $needed"
}

# compiles_alone FOLDER HEADER: HEADER is a path below FOLDER.
compiles_alone() {
  printf '#include <%s>\n' "$2" | "$CXX" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Werror "-I$1" -x c++ - ||
    fail "$2 does not compile alone"
}

# Those of the package with what the package has; the library's own in the tree.
check_headers() {
  local header
  diff <(cd "$prefix/include/libcanopen" && find . -type f -printf '%P\n' | LC_ALL=C sort) \
    "$SOURCE_DIR/libcanopen/package/headers.txt" || fail "other headers were installed than headers.txt names"
  while read -r header; do
    if [[ -e $prefix/include/$header ]]; then
      compiles_alone "$prefix/include" "$header"
    else
      compiles_alone "$SOURCE_DIR" "$header"
    fi
  done < <(cd "$SOURCE_DIR" && find libcanopen -name '*.hpp')
}

# Without optimisation, and with every inline function of every header kept: what they call must be exported.
check_inline_functions() {
  { find "$prefix/include" -type f -printf '#include <%P>\n'; echo 'int main() {}'; } >"$work/all.cpp"
  "$CXX" -std=c++20 -fkeep-inline-functions -o "$work/all" "$work/all.cpp" "-I$prefix/include" "-L$prefix/lib" -lcanopen
}

check_standalone() {
  build "$SOURCE_DIR/libcanopen" "$work/build-lib"
  "$CMAKE" --install "$work/build-lib" --prefix "$work/alone"
  diff <(cd "$prefix" && find . | sort) <(cd "$work/alone" && find . | sort)
}

install_package
"check_$1"
