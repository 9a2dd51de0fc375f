#!/bin/sh
# own_journal.sh COMMAND...: runs it where /run is empty and its own, with the socket of no journal in it. Needs root, or user
# namespaces.
set -eu
if [ "${AXISD_OWN_JOURNAL:-}" != yes ]; then
  user=''
  [ "$(id -u)" = 0 ] || user=--map-root-user
  AXISD_OWN_JOURNAL=yes exec unshare $user --mount --net "$0" "$@"
fi
mount -t tmpfs none /run
exec "$@"
