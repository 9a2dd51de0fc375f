#!/usr/bin/env bash
# check_write_version.sh CHECK: lets SCRIPT, which CMAKE runs, write the header of the version for a repository made here.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/tree header=$work/build/version.hpp
# Nothing of whoever runs this may count.
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1 GIT_CEILING_DIRECTORIES=$work
unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

fail() { echo "$*" >&2; exit 1; }
in_tree() { git -C "$tree" -c user.name=a -c user.email=a@example.org "$@"; }
commit() { echo "$1" >"$tree/file" && in_tree add file && in_tree commit -q -m "$1"; }
write() { "$CMAKE" -D SOURCE="$1" -D NUMBER=1.2.3 -D OUTPUT="$header" -P "$SCRIPT"; }
expect() { # NAME VALUE
  grep -qxF "inline constexpr const char* $1 = \"$2\";" "$header" || fail "expected $1 \"$2\" in:"$'\n'"$(<"$header")"
}
head_of_tree() { in_tree rev-parse --short=10 HEAD; }

mkdir "$tree"
git init -q "$tree"
commit first

case $1 in
  Commit)
    write "$tree"
    expect kNumber 1.2.3
    expect kCommit "$(head_of_tree)"
    commit second
    write "$tree"
    expect kCommit "$(head_of_tree)" ;;
  Tag)
    in_tree tag -a -m tag v1
    write "$tree"
    expect kCommit "$(head_of_tree)" ;;
  Change)
    echo changed >"$tree/file"
    write "$tree"
    expect kCommit "$(head_of_tree)-dirty" ;;
  Foreign)  # a tarball that was unpacked within somebody's repository
    mkdir "$tree/tarball"
    write "$tree/tarball"
    expect kCommit '' ;;
  None)
    rm -rf "$tree/.git"
    write "$tree"
    expect kNumber 1.2.3
    expect kCommit '' ;;
  Unmoved)
    write "$tree"
    touch -d 2001-01-01 "$header"
    write "$tree"
    [[ $(date -r "$header" +%Y) == 2001 ]] || fail "the header was written again, though the commit is the same" ;;
  *) fail "unknown check $1" ;;
esac
