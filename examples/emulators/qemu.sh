#!/usr/bin/env bash
# qemu.sh: a guest with an emulated CAN controller on the user-space bus, where the kernel of this machine has no CAN.
#
# usage: qemu.sh [OPTION]... [SCRIPT [ARGUMENT]...]
#
#   --bus PATH       the user-space bus is at PATH (default: that of with-can)
#   --socketcan IF   no user-space bus: the interface IF of this machine
#   --device NAME    kvaser_pci (the default), pcm3680_pci, mioe3680_pci or ctucan_pci
#   --file FILE      hands FILE on to the guest, which finds it in its current folder; may be repeated
#   --timeout S      end the guest after S seconds
#   --help           this text
#
# The guest is Debian's kernel with bash, busybox, ip and can-utils. It runs SCRIPT with bash, or a shell at this terminal
# (the guest ends with it; Ctrl-A X ends it at once). can0 is down until it is set up there:
#   ip link set can0 up type can bitrate 500000
# The kernel is downloaded once into $VCAN_VM_CACHE (default: vcan-vm in the XDG cache directory) and never installed.
#
# The standard input of SCRIPT is empty. The exit status is that of SCRIPT; 124 after --timeout; 125 when the guest ended
# without one; 2 for wrong usage.
set -euo pipefail

fail() { echo "qemu.sh: $1" >&2; exit 2; }
# shellcheck source=scripts/debian-guest.sh
. "$(dirname "$(realpath "$0")")/../../scripts/debian-guest.sh"

bus=(with-can --) interface=vcan0 device=kvaser_pci files=() limit=0
while (($#)); do
  case $1 in
    --bus | --socketcan | --device | --file | --timeout) (($# > 1)) || fail "$1 needs a value" ;;&
    --bus) bus=(with-can --bus "$2" --) ;;
    --socketcan) bus=() interface=$2 ;;
    --device) device=$2 ;;
    --file) files+=("$2") ;;
    --timeout) limit=$2 ;;
    --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
    -*) fail "unknown option $1 (--help lists them)" ;;
    *) break ;;
  esac
  shift 2
done
((${#bus[@]} == 0)) || command -v with-can >/dev/null || fail "there is no with-can in PATH"
case $device in  # one controller, or two on the same wire
  kvaser_pci) controllers=canbus=wire ;;
  pcm3680_pci | mioe3680_pci | ctucan_pci) controllers=canbus0=wire,canbus1=wire ;;
  *) fail "unknown device $device (--help lists them)" ;;
esac

# shellcheck disable=SC2016  # the guest's variables, not ours
first_program='#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
ln -s /proc/self/fd /dev/fd
for module in can can-raw can-bcm kvaser_pci; do modprobe $module; done
cd /job
bash ./start </dev/ttyS0 >/dev/ttyS0 2>&1
printf %s $? >/dev/ttyS1
poweroff -f'
mapfile -t programs < <(command -v bash ip candump cansend cangen cansequence canbusload)
((${#programs[@]} == 7)) || fail "missing Debian packages: apt-get install can-utils iproute2"
make_guest "$first_program" 'can can-raw can-bcm kvaser_pci sja1000_isa' "${programs[@]}"

# What this guest is to do comes behind the files that all guests have: the kernel takes one archive after the other.
work=$(mktemp -d) machine=''
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [[ -z $machine ]] || kill "$machine" 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
mkdir "$work/job"
((${#files[@]} == 0)) || cp -L "${files[@]}" "$work/job/"
if (($#)); then
  cat "$1" >"$work/job/script" || fail "$1 cannot be read"
  shift
  printf 'stty -onlcr\nexec bash ./script %s\n' "${*@Q}" >"$work/job/start"
  terminal=(-serial stdio)
  exec </dev/null # what stands behind this command in a script is none of the guest's
else
  echo 'exec setsid -c bash' >"$work/job/start"
  terminal=(-serial mon:stdio)
fi
(cd "$work" && { cat "$guest_files" && find job | cpio -o -H newc --quiet | gzip -1; } >files)

"${bus[@]}" timeout --foreground --kill-after=5 "$limit" qemu-system-x86_64 -accel tcg -cpu max -m 192 "${guest_machine[@]}" \
  -object can-bus,id=wire -object can-host-socketcan,id=host,if="$interface",canbus=wire -device "$device,$controllers" \
  -kernel "$guest_kernel" -initrd "$work/files" -append "console=ttyS2 $guest_options $guest_clock" \
  "${terminal[@]}" -serial "file:$work/status" -serial "file:$work/console" <&0 &
machine=$! status=0
wait "$machine" || status=$?
machine=''
[[ ! -s $work/status ]] || exit "$(<"$work/status")"
((status != 124)) || { echo "qemu.sh: the guest ended after $limit s" >&2; exit 124; }
{ echo "qemu.sh: the guest gave no exit status; its last lines:"; tail -n 20 "$work/console"; } >&2
exit 125
