#!/usr/bin/env bash
# setup.sh: installs what building, testing and demonstrating need and what is missing of it (Debian 12).
# To be called or sourced. Of machines that have everything it changes nothing.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=(
  # to build
  g++ cmake ninja-build pkg-config git ca-certificates
  # libraries of the daemon and the tools
  libsystemd-dev nlohmann-json3-dev libeigen3-dev libexpected-dev libcli11-dev libfmt-dev
  # tests and benchmarks
  libgtest-dev libgmock-dev libbenchmark-dev
  # the CAN bus: candump and cansend, ip, and modprobe for the module vcan
  can-utils iproute2 kmod
  # masters of the tests: python-can and what its udp_multicast needs; unshare for networks of their own
  python3-can python3-msgpack util-linux
  # form and faults of the source
  clang-format clang-tidy
  # systemd-analyze, which checks the units
  systemd
)
# the virtual machine of scripts/vcan-vm, only where the kernel has no CAN
machine_packages=(qemu-system-x86 busybox-static cpio)

command -v dpkg-query >/dev/null || die "only Debian and its relatives are supported"
need_packages "${packages[@]}"
if ! have_can; then
  need_packages "${machine_packages[@]}"
  # An image of Debian comes without package lists, and vcan-vm fetches a kernel by them.
  apt-cache show linux-image-amd64 &>/dev/null || update_package_lists
fi
# Who sources this decides whether the independent master is worth its time.
[[ ${BASH_SOURCE[0]} != "$0" ]] || need_master || die "the npm packages of tests/e2e/master could not be installed"
