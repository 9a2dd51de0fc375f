#!/usr/bin/env bash
# setup.sh [--demo|--build]: installs what building, testing and demonstrating need and what is missing of it (Debian 12).
# To be called or sourced. Of machines that have everything it changes nothing.
#
# --demo: what scripts/demo.sh needs: the packages of the build, and can-utils.
# --build: the same, and npm for the page of axisd-http: what building all that is installed needs.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case ${1:-} in
  '' | --build | --demo) ;;
  *) echo "usage: setup.sh [--demo|--build]" >&2; exit 2 ;;
esac
purpose=${1:-}

build_packages=(
  # to build
  g++ cmake ninja-build pkg-config git ca-certificates
  # libraries of the daemon and the tools
  libsystemd-dev nlohmann-json3-dev libexpected-dev libcli11-dev libfmt-dev libeigen3-dev
  # HTTP of axisd-http
  libmicrohttpd-dev
  # buses over several hosts, and farms
  libnats-dev libssl-dev
  # man pages
  scdoc
  # candump and cansend
  can-utils
)
test_packages=(
  # tests and benchmarks, and what links them faster
  libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev lld
  # ip, modprobe for the module vcan, and unshare for networks of their own
  iproute2 kmod util-linux
  # masters of the tests
  python3-can python3-msgpack python3-pytest python3-pytest-xdist python3-yaml
  # the server that joins the hubs of several hosts
  nats-server
  # clients of Modbus TCP, and who decodes what they send
  mbpoll python3-pymodbus python3-serial-asyncio tshark
  # holds the schema of configurations against their reader
  python3-jsonschema
  # form and faults of the source
  clang-format clang-tidy
  # xmllint, which holds reports against a schema
  libxml2-utils
  # systemd-analyze, which checks the units, and what confines programs as these do
  systemd python3-seccomp
  # the page of axisd-http in a browser
  chromium
  # certificates, and the driver of units for labgrid
  openssl python3-labgrid
)
# guests of the tests, and the virtual machine of scripts/vcan-vm where the kernel has no CAN
machine_packages=(qemu-system-x86 busybox-static cpio)

command -v dpkg-query >/dev/null || die "only Debian and its relatives are supported"
need_packages "${build_packages[@]}"
[[ $purpose == --demo ]] || command -v npm >/dev/null || need_packages nodejs npm
if [[ ! $purpose ]]; then
  need_packages "${test_packages[@]}"
  need_packages "${machine_packages[@]}"
  # An image of Debian comes without package lists, and debian-guest.sh fetches a kernel by them.
  apt-cache show linux-image-amd64 &>/dev/null || update_package_lists
fi
# Who sources this decides whether the independent master is worth its time.
[[ ${BASH_SOURCE[0]} != "$0" || $purpose ]] || need_master || die "the npm packages of tests/e2e/master could not be installed"
