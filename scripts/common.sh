# shellcheck shell=bash
# What the scripts of this folder share; to be sourced. Sets `root`, the top of the source tree.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2034  # for those who source this
jobs=$(nproc)

# say TEXT...: one line on what is done next.
say() { echo "-- $*"; }

# die TEXT...: one line on what is wrong, and the end.
die() { echo "${0##*/}: $*" >&2; exit 1; }

# misuse TEXT...: one line on what is wrong with the command line, and the end.
misuse() { echo "${0##*/}: $*" >&2; exit 2; }

# need_number OPTION [VALUE]: ends the script unless VALUE is a number from 1 on.
need_number() { [[ ${2:-} =~ ^[1-9][0-9]{0,8}$ ]] || misuse "$1 needs a number from 1 on"; }

# as_root COMMAND...: runs it as root, through sudo where necessary.
as_root() {
  if ((EUID == 0)); then "$@"
  elif command -v sudo >/dev/null; then sudo "$@"
  else die "needs root (or sudo) for: $*"
  fi
}

# need_packages PACKAGE...: installs the Debian packages that are missing, and touches nothing if none is.
need_packages() {
  local package answer missing=()
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == 'install ok installed' ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  say "installing ${missing[*]}"
  update_package_lists
  answer=$(as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" 2>&1) || {
    echo "$answer" >&2
    die "these packages could not be installed: ${missing[*]}"
  }
}

# node_prefix: where node is installed, its headers below include/.
node_prefix() { node -p 'require("path").resolve(process.execPath, "../..")' 2>/dev/null; }

# need_master: the npm packages of the independent master (tests/e2e/master) in build/master/node_modules, and what npm
# needs to build them where it is missing. Does nothing where they are as the lock file says.
need_master() {
  local source=$root/tests/e2e/master target=$root/build/master packages=() wanted answer
  command -v make >/dev/null || packages+=(make)
  command -v python3 >/dev/null || packages+=(python3)
  { command -v npm && [[ -e $(node_prefix)/include/node/node.h ]]; } >/dev/null || packages+=(nodejs npm libnode-dev)
  ((${#packages[@]} == 0)) || need_packages "${packages[@]}"
  wanted=$(node --version && sha256sum "$source"/package*.json | cut -d' ' -f1) || return 1
  [[ ! -e $target/complete || $(<"$target/complete") != "$wanted" ]] || return 0
  say "installing the npm packages of the independent master"
  mkdir -p "$target" && rm -f "$target/complete"
  cp "$source"/{package.json,package-lock.json,.npmrc} "$target" || return 1
  answer=$(cd "$target" && npm_config_nodedir=$(node_prefix) npm ci --no-audit --no-fund 2>&1) || {
    echo "$answer" >&2
    return 1
  }
  echo "$wanted" >"$target/complete"
}

# update_package_lists: apt-get update, once a script.
update_package_lists() {
  [[ -z ${lists_are_fresh:-} ]] || return 0
  as_root apt-get update -qq || die "apt-get update failed"
  lists_are_fresh=yes
}

# build PRESET [TARGET...]: configures and builds a preset of CMakePresets.json into build/PRESET.
build() {
  local preset=$1 answer
  shift
  say "building $preset"
  answer=$(cd "$root" && cmake --preset "$preset" 2>&1) || { echo "$answer" >&2; return 1; }
  # Ninja's own number of jobs is two more than there are processors; a compiler here may need a gigabyte.
  (cd "$root" && cmake --build --preset "$preset" -j "$jobs" ${1:+--target "$@"})
}

# have_can: whether this kernel gives us vcan0 and vcan1, which are made here if they can be. Says nothing.
have_can() {
  "$root/scripts/vcan-setup.sh" vcan0 &>/dev/null && "$root/scripts/vcan-setup.sh" vcan1 &>/dev/null
}

# run_on_can COMMAND...: runs it from the top of the tree, here if there is CAN, else in the virtual machine, which keeps what
# is written below $VCAN_VM_OUT.
run_on_can() (
  cd "$root" || exit 1
  if have_can; then
    exec "$@"
  fi
  say "this kernel has no virtual CAN: running in the virtual machine of scripts/vcan-vm"
  exec scripts/vcan-vm --mem 2048 --timeout "${VCAN_VM_TIMEOUT:-1800}" ${VCAN_VM_OUT:+--out "$VCAN_VM_OUT"} -- "$@"
)
