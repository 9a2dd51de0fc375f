#!/usr/bin/env bash
# vcan-setup.sh [IF]: makes the virtual CAN interface IF (vcan0) and sets it up; nothing to do is success.
# Says what is missing, and ends with 1, where that cannot be done.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "$0")/common.sh"

name=${1:-vcan0}
command -v ip >/dev/null || die "the program ip is missing: apt-get install iproute2"

is_up() { [[ $(ip -o link show dev "$name" up 2>/dev/null) ]]; }
kind() { ip -o -d link show dev "$name" 2>/dev/null | grep -ow 'vcan\|link/can' | tail -n 1; }

if is_up && [[ $(kind) == vcan ]]; then exit 0; fi
if [[ -e /sys/class/net/$name && $(kind) != vcan ]]; then die "$name exists and is no virtual CAN interface"; fi
((EUID == 0)) || command -v sudo >/dev/null || die "no privilege to make $name: neither root nor sudo"

if [[ ! -e /sys/class/net/$name ]]; then
  # The kernel loads the module by itself when asked for the interface, except where a container keeps it from doing so.
  as_root modprobe vcan 2>/dev/null || true
  if ! answer=$(as_root ip link add dev "$name" type vcan 2>&1); then
    case $answer in
      *'Unknown device type'* | *'not supported'*)
        die "this kernel ($(uname -r)) has no module vcan: install the distribution's kernel modules, or use scripts/vcan-vm" ;;
      *'not permitted'*) die "no privilege to make $name: the capability CAP_NET_ADMIN is missing" ;;
      *) [[ -e /sys/class/net/$name ]] || die "ip link add $name: $answer" ;;  # somebody else was faster
    esac
  fi
fi
answer=$(as_root ip link set dev "$name" up 2>&1) || die "ip link set $name up: $answer"
