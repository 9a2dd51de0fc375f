#!/bin/sh
# own_network.sh COMMAND...: runs it in a network of its own that has only lo, with routes for python-can's groups: nothing
# leaves the machine. Needs root, or user namespaces.
set -eu
if [ "${AXISD_OWN_NETWORK:-}" != yes ]; then
  user=''
  [ "$(id -u)" = 0 ] || user=--map-root-user
  AXISD_OWN_NETWORK=yes exec unshare $user --net "$0" "$@"
fi
ip link set lo up
ip route add 239.74.163.2 dev lo
ip -6 route add local ff15:7079:7468:6f6e:6465:6d6f:6d63:6173 dev lo
exec "$@"
