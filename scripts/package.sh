#!/usr/bin/env bash
# package.sh [OPTION]... [STEP...]: builds the packages of Debian from a fresh clone of the last commit, and tries them.
#
#   build      the packages into build/packages, and those of the version before into build/packages/before
#   judge      lintian's opinion, and the hardening of each binary
#   root       a clean root of Debian 12 with what the packages depend on in its cache (needs root and the network)
#   try        in that root: installation, first session, upgrade from the version before with its state, a configuration that
#              the new version does not take, removal while a unit runs, removal, purge (needs root, no network)
#   services   in that root with systemd, in the virtual machine of vcan-vm: services are enabled, upgraded, and removed (needs root)
# #
# Without STEP all of them. Options:
#   --from COMMIT   what the version before is made of (default: the last commit that had another version)
#
# The last line is "N passed, M failed"; the exit status is 0 if M is 0.
# shellcheck disable=SC2317  # functions are called by `check`
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

all_steps=(build judge root try services) steps=() from=''
while (($#)); do
  case $1 in
    --from) from=${2:?"a commit is missing"}; shift 2 ;;
    build | judge | root | try | services) steps+=("$1"); shift ;;
    *) echo "usage: ${0##*/} [--from COMMIT] [${all_steps[*]}]..." >&2; exit 2 ;;
  esac
done
((${#steps[@]})) || steps=("${all_steps[@]}")

place=$root/build/packages passed=0 failed=0
mkdir -p "$place"

# check NAME COMMAND...: a step that counts as one test.
check() {
  local name=$1
  shift
  say "$name"
  # Not as a condition, within which no command would end what fails.
  set +e
  (set -e; "$@")
  local status=$?
  set -e
  if ((status == 0)); then
    ((passed += 1))
  else
    ((failed += 1))
    echo "FAILED: $name"
  fi
}

# ---- build

# clone COMMIT FOLDER: the sources of a commit as they are fetched by anybody.
clone() {
  rm -rf "$2"
  git clone -q --no-checkout "$root" "$2" && git -C "$2" checkout -q --detach "$1"
}

# versions_before: the last commits with another version, the last one first: one amid a change may not build.
versions_before() {
  local change
  change=$(git -C "$root" log -1 --format=%H -G'^project\(axisd VERSION' -- CMakeLists.txt)
  [[ $change ]] || { echo "the commits do not reach back to another version: name one by --from" >&2; return 1; }
  git -C "$root" rev-list --max-count=10 "$change^"
}

# make_packages FOLDER TARGET: builds the packages of the sources in FOLDER and moves them to TARGET.
make_packages() {
  (cd "$1" && cmake --preset package >/dev/null && cmake --build --preset package -j "$jobs" >"$place/build.log" &&
    cd build/package && cpack >>"$place/build.log" 2>&1) || { tail -n 30 "$place/build.log" >&2; return 1; }
  mkdir -p "$2"
  rm -f "$2"/*.deb
  mv "$1"/build/package/packages/*.deb "$2"
}

build_packages() {
  [[ -z $(git -C "$root" status --porcelain) ]] || say "what is not committed is not in the packages"
  clone HEAD "$place/source"
  make_packages "$place/source" "$place"
  ls -l "$place"/*.deb
}

# wrap_installation FOLDER TARGET: packages axisd and can-userbus of a version that had none: of its files those that these
# packages have now, without scripts.
wrap_installation() {
  local source=$1 target=$2 version name files=$place/before-root
  version=$(sed -n 's/^project(axisd VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
  (cd "$source" && cmake --preset release -DCMAKE_INSTALL_PREFIX=/usr -DAXISD_TESTS=OFF -DAXISD_BENCH=OFF >/dev/null &&
    cmake --build --preset release -j "$jobs" --target installed >"$place/build.log" 2>&1) || { tail -n 30 "$place/build.log" >&2; return 1; }
  rm -rf "$files"
  DESTDIR=$files/all cmake --install "$source/build/release" >/dev/null
  mkdir -p "$target"
  rm -f "$target"/*.deb
  for name in axisd can-userbus; do
    mkdir -p "$files/$name/DEBIAN"
    (cd "$files/all" && dpkg-deb -c "$(echo "$place/$name"_*.deb)" | awk '$1 ~ /^-/ {print $6}' |
      while read -r file; do [[ ! -e $file ]] || cp -a --parents "$file" "$files/$name"; done)
    cat >"$files/$name/DEBIAN/control" <<CONTROL
Package: $name
Version: $version-1
Architecture: $(dpkg --print-architecture)
Maintainer: $(dpkg-deb -f "$(echo "$place/$name"_*.deb)" Maintainer)
Depends: $(dpkg-deb -f "$(echo "$place/$name"_*.deb)" Depends)
Description: $name before it was a package
CONTROL
    dpkg-deb --root-owner-group -b "$files/$name" "$target" >/dev/null
  done
  rm -rf "$files"
}

# make_before COMMIT: the packages of that version.
make_before() {
  clone "$1" "$place/source-before" || return
  if grep -qs '"name": "package"' "$place/source-before/CMakePresets.json"; then
    make_packages "$place/source-before" "$place/before"
  else
    wrap_installation "$place/source-before" "$place/before"
  fi
}

build_before() {
  local commit
  for commit in ${from:-$(versions_before)}; do
    if make_before "$commit"; then
      ls -l "$place"/before/*.deb
      return
    fi
    echo "the version before: $commit cannot be built"
  done
  return 1
}

# ---- judge

lint() { lintian --profile debian --fail-on error,warning --allow-root "$place"/*.deb; }

# hardening: a line a binary; all must be hardened by all means that their kind has.
hardening() {
  local work package file sections symbols row wrong=0
  work=$(mktemp -d)
  printf '%-58s %-4s %-6s %-5s %-6s %-7s %s\n' binary PIE RELRO NOW stack FORTIFY 'no run path'
  for package in "$place"/*.deb; do
    dpkg-deb -x "$package" "$work/$(basename "$package")"
  done
  while read -r file; do
    sections=$(readelf -Whld "$file")
    symbols=$(readelf -Ws --dyn-syms "$file")
    row=()
    has() { if grep -qE "$1" <<<"$2"; then row+=(yes); else row+=(no); fi; }
    has ' Type: +DYN' "$sections"
    has GNU_RELRO "$sections"
    has 'BIND_NOW|Flags:.* NOW' "$sections"
    has __stack_chk_fail "$symbols"
    # A library that calls none of the functions in question has none that is checked.
    if grep -qE ' (mem(cpy|set|move)|str(cpy|cat)|v?s?n?printf)@' <<<"$symbols" && ! grep -qE '__[a-z]+_chk@' <<<"$symbols"; then
      [[ $file == *libcanopen* ]] && row+=(none) || row+=(no)
    else
      row+=(yes)
    fi
    if grep -qE 'RPATH|RUNPATH' <<<"$sections"; then row+=(no); else row+=(yes); fi
    printf '%-58s %-4s %-6s %-5s %-6s %-7s %s\n' "${file#"$work/"}" "${row[@]}"
    [[ " ${row[*]} " != *' no '* ]] || wrong=1
  done < <(find "$work" -type f \( -path '*/bin/*' -o -name '*.so*' \) | sort)
  rm -rf "$work"
  ((wrong == 0))
}

# ---- root

# in_root FOLDER COMMAND...: runs it in the root FOLDER with the network of this machine, for apt.
in_root() {
  local folder=$1
  shift
  # shellcheck disable=SC2016  # of the shell that is started
  as_root unshare --mount bash -c 'mount --rbind /dev "$0/dev" && mount -t proc none "$0/proc" &&
    mount --bind /etc/resolv.conf "$0/etc/resolv.conf" && exec chroot "$0" "$@"' "$folder" "$@"
}

make_root() {
  local folder=$place/root
  as_root rm -rf "$folder"
  # python3 is there before: apt does not take it away with python3-axisd, as packages of every system suggest it.
  as_root mmdebstrap --quiet --variant=minbase --include=can-utils,iproute2,procps,python3 bookworm "$folder"
  as_root mkdir -p "$folder/packages"
  as_root cp "$place"/*.deb "$folder/packages"
  as_root touch "$folder/etc/resolv.conf"
  in_root "$folder" apt-get update -qq
  # What is installed later is fetched now: only into the cache, and without what the trial is about.
  in_root "$folder" bash -c 'apt-get install -qq -y --download-only --no-install-recommends /packages/*.deb systemd-sysv udev dbus nats-server'
  as_root rm -rf "$folder/packages"
}

# ---- try

# try SCRIPT: runs one of packaging/try/ in the clean root: in a machine of its own as far as that goes without one: processes,
# mounts and network are its own, and nothing is left of them when it has ended.
try() {
  # shellcheck disable=SC2016  # of the shell that is started
  as_root env NEW_VERSION="axisd $(dpkg-deb -f "$(echo "$place"/axisd_*.deb)" Version | sed 's/-.*//')" \
    unshare --mount --pid --fork --net --ipc --uts --kill-child bash -c '
      ip link set lo up && mount --rbind /dev "$0/dev" && mount -t proc none "$0/proc" && mount -t tmpfs none "$0/run" &&
        mount -t tmpfs none "$0/tmp" && mount --bind "$1" "$0/packages" && mount --bind "$1/before" "$0/before" && mount --bind "$2" "$0/try" &&
        PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root exec chroot "$0" "/try/$3"' \
    "$place/clean" "$place" "$root/packaging/try" "$1"
}

clean_root() {
  as_root rm -rf "$place/clean"
  as_root cp -a "$place/root" "$place/clean"
  as_root mkdir -p "$place/clean"/{packages,before,try}
  try files.sh | as_root tee "$place/clean/var/lib/try.files" >/dev/null
}

# ---- services

services() {
  local folder=$place/clean
  as_root rm -rf "$folder"
  as_root cp -a "$place/root" "$folder"
  as_root mkdir -p "$folder"/{packages,before,try}
  as_root cp "$place"/*.deb "$folder/packages"
  as_root cp "$place"/before/*.deb "$folder/before"
  as_root cp "$root"/packaging/try/*.sh "$folder/try"
  # Before the machine is started, in which everything takes ten times as long.
  in_root "$folder" bash -c 'apt-get install -qq -y --no-install-recommends systemd-sysv udev dbus /before/*.deb' >/dev/null
  "$root/scripts/vcan-vm" --mem 1536 --timeout 1200 -- "$root/packaging/try/boot.sh" "$folder" /try/services.sh
  as_root rm -rf "$folder"
}

# ---- the steps

for step in "${steps[@]}"; do
  case $step in
    build)
      "$root/scripts/setup.sh" --build
      need_packages dpkg-dev
      check 'packages from a fresh clone' build_packages
      check 'packages of the version before' build_before ;;
    judge)
      need_packages lintian binutils
      check 'lintian' lint
      check 'hardening' hardening ;;
    root)
      need_packages mmdebstrap
      check 'clean root' make_root ;;
    try)
      check 'clean root, its files' clean_root
      check 'first session' try session.sh
      check 'library' try library.sh
      check 'purge leaves nothing' try purge.sh
      clean_root
      check 'the version before' try before.sh
      check 'upgrade with the state of the version before' try upgrade.sh
      check 'removal while a unit runs' try removal_while_running.sh
      check 'purge after the upgrade leaves nothing' try purge.sh
      as_root rm -rf "$place/clean" ;;
    services) check 'services under systemd' services ;;
  esac
done
echo "$passed passed, $failed failed"
exit $((failed > 0))
