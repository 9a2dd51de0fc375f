#!/bin/sh
# on_private_bus.sh WITH_CAN COMMAND...: runs COMMAND with CAN sockets on a bus that nobody else knows.
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
with_can=$1
shift
"$with_can" --bus "$folder/bus" -- "$@"
