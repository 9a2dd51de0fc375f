#!/usr/bin/env bash
# What a maker of programs finds of the library, and the loader of them. There is no compiler in the clean root: tests/package builds
# with what is installed.
# shellcheck source=packaging/try/common.sh
. "${0%/*}/common.sh"

folder=$(echo /usr/lib/*/cmake/libcanopen)
for file in "$folder/libcanopen-config.cmake" "$folder/../../pkgconfig/libcanopen.pc" "$folder/../../libcanopen.a" \
  "$folder/../../libcanopen.so" /usr/include/libcanopen/node/node.hpp; do
  [[ -e $file ]] || fail "$file is missing, or points to nothing"
done
ldconfig -p | grep -qF libcanopen.so.0 || fail "the loader does not know libcanopen.so.0"
