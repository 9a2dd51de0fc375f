#!/bin/sh
# own_can.sh COMMAND...: runs it in a network of its own that has lo and SocketCAN's vcan0 and vcan1, so that tests may run side
# by side. Needs root, or user namespaces, and the kernel's module vcan, loaded.
set -eu
if [ "${AXISD_OWN_CAN:-}" != yes ]; then
  user=''
  [ "$(id -u)" = 0 ] || user=--map-root-user
  AXISD_OWN_CAN=yes exec unshare $user --net "$0" "$@"
fi
ip link set lo up
for name in vcan0 vcan1; do
  ip link add dev $name type vcan
  ip link set $name up
done
exec "$@"
