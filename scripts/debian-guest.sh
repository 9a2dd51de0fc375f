# shellcheck shell=bash disable=SC2034  # what is set here is for those who source this
# debian-guest.sh: Debian's kernel and an initial file system for a guest in qemu, made once and kept. To be sourced by
# scripts that have a function `fail TEXT` which ends them.

# What a guest is that is emulated in software on a busy machine, before its memory, devices and programs.
# no_timer_check: the emulated timer may come too late for the kernel's test of it, which then panics.
guest_machine=(-nodefaults -no-user-config -no-reboot -display none -rtc base=utc)
guest_options='quiet loglevel=3 panic=-1 no_timer_check'
# The kernel finds the rate of the time stamp counter by trial, which fails on a busy machine: seconds then last as long
# as they please. The HPET has a known rate; it costs a microsecond a reading.
guest_clock='clocksource=hpet'

# need_guest_tools: ends the script unless a guest can be made and emulated here.
need_guest_tools() {
  local missing=()
  [[ $(uname -m) == x86_64 ]] || fail "the guest runs this machine's programs and is x86-64; this machine is not"
  command -v qemu-system-x86_64 >/dev/null || missing+=(qemu-system-x86)
  # The initial file system may hold no libraries, so the dynamically linked busybox would not start.
  guest_busybox=$(command -v busybox) && ! ldd "$guest_busybox" &>/dev/null || missing+=(busybox-static)
  command -v cpio >/dev/null || missing+=(cpio)
  ((${#missing[@]} == 0)) || fail "missing Debian packages: apt-get install ${missing[*]}"
}

# debian_kernel CACHE: prints the directory of an unpacked Debian kernel, which is downloaded if there is none. It appears under
# its final name only when complete.
debian_kernel() {
  local cache=$1 have package new
  have=$(find "$cache" -maxdepth 1 -name 'linux-image-*-amd64' | sort -V | tail -n 1)
  [[ -z $have ]] || { echo "$have"; return; }
  package=$(apt-cache depends linux-image-amd64 2>/dev/null | sed -n 's/^ *Depends: \(linux-image-[^ ]*\)$/\1/p' | head -n 1)
  [[ -n $package ]] || fail "apt knows no package linux-image-amd64: apt-get update"
  new=$(mktemp -d "$cache/unpack.XXXXXX")
  # apt wants to drop root for a user who may be unable to write to this directory.
  (cd "$new" && apt-get download -qq -o APT::Sandbox::User=root "$package" >&2) ||
    fail "$package could not be downloaded (lists out of date? apt-get update)"
  dpkg-deb -x "$new"/linux-image-*.deb "$new/$package"
  busybox depmod -b "$new/$package" "$(ls "$new/$package/lib/modules")"
  mv "$new/$package" "$cache/"
  rm -rf "$new"
  echo "$cache/$package"
}

# initial_files CACHE KERNEL INIT MODULES [PROGRAM...]: prints the initial file system for the kernel in KERNEL: busybox, the text
# INIT as /init, the modules with all they depend on, and programs of this machine with their libraries. Its name tells
# what it was made from, so an old one is never taken for a new one, and a machine that is just starting from the old one
# is not disturbed.
initial_files() {
  local cache=$1 kernel=$2 init=$3 modules=$4 version programs image new files
  shift 4
  version=$(ls "$kernel/lib/modules")
  mapfile -t programs < <((($# == 0)) || { printf '%s\n' "$@"; ldd "$@" | grep -o '/[^ :]* (0x'| sed 's/ (0x//'; } | sort -u)
  image=$cache/initrd-$version-$({ echo "$init $modules"; cat "$guest_busybox" "${programs[@]}"; } | sha256sum | head -c 16).gz
  if [[ ! -e $image ]]; then
    new=$(mktemp -d "$cache/unpack.XXXXXX")
    mkdir -p "$new/root"/{bin,dev,host,layer,lib/modules,proc,root,run,sys,tmp}
    ((${#programs[@]} == 0)) || cp -L --parents "${programs[@]}" "$new/root"
    cp "$guest_busybox" "$new/root/bin/busybox"
    cat >"$new/root/init" <<<"$init"
    chmod +x "$new/root/init"
    # Modules load with all they depend on, which depmod has found out: a new kernel may cut them differently.
    mapfile -t files < <(awk -v wanted="$modules" '
      BEGIN { FS = "[: ]+"; split(wanted, list, " "); for (i in list) want["/" list[i] ".ko"] }
      { file = $1; sub(/.*\//, "/", file) }
      file in want { for (i = 1; i <= NF; i++) if ($i != "") print $i }' "$kernel/lib/modules/$version/modules.dep" | sort -u)
    (cd "$kernel/lib/modules" && cp --parents "${files[@]/#/$version/}" "$new/root/lib/modules/")
    busybox depmod -b "$new/root" "$version"
    (cd "$new/root" && find . | cpio -o -H newc --quiet | gzip -1) >"$new/image"
    mv "$new/image" "$image"
    rm -rf "$new"
  fi
  echo "$image"
}

# make_guest INIT MODULES [PROGRAM...]: sets guest_kernel and guest_files, what qemu is to boot. They are kept in
# $VCAN_VM_CACHE (default: vcan-vm in the XDG cache directory).
make_guest() {
  local cache lock kernel
  need_guest_tools
  cache=$(realpath -m "${VCAN_VM_CACHE:-${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/vcan-vm}")
  mkdir -p "$cache"
  # Several guests may start at once with an empty cache: one makes the files, the others wait for them.
  exec {lock}>"$cache/lock"
  flock "$lock"
  rm -rf "$cache"/unpack.*  # left by a run that was interrupted: under the lock nobody is at work on one
  kernel=$(debian_kernel "$cache")
  guest_files=$(initial_files "$cache" "$kernel" "$@")
  guest_kernel=$(echo "$kernel"/boot/vmlinuz-*)
  exec {lock}>&-
}
