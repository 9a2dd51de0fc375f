#!/usr/bin/env bash
# boot.sh FOLDER COMMAND...: in the virtual machine of scripts/vcan-vm: boots the systemd of the root FOLDER with the interfaces of
# the machine, runs COMMAND there and ends with its status.
set -euo pipefail
folder=$1
shift

# A process and mount namespace in which systemd is the first process and FOLDER is all there is. It is made from the root of the
# machine's first process, below which that of the caller lies: who has another root than its namespace may make no users of its own.
# shellcheck disable=SC2016  # the variables of the shell that is started
nsenter --target 1 --mount --root --wd /bin/busybox unshare -m -p -f /bin/busybox sh -c '
  mount --bind "$0" "$0" && cd "$0" && mount -t proc proc proc && mount -t sysfs sysfs sys && mount -t cgroup2 none sys/fs/cgroup &&
    mount -t devtmpfs dev dev && mount -t tmpfs run run && mount --move . / && exec chroot . /lib/systemd/systemd' "/root$folder" \
  </dev/null &>/dev/null &
launcher=$!

inside() { nsenter --target "$first" --mount --pid --root --wd env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb "$@"; }

first=''
for ((i = 0; i < 300; i++)); do
  kill -0 "$launcher" 2>/dev/null || { echo "systemd did not start" >&2; exit 1; }
  first=$(pgrep -P "$launcher" | head -n 1) || true
  [[ -z $first ]] || ! inside systemctl is-system-running --wait &>/dev/null || break
  # "degraded" is running as well; what has failed is shown.
  [[ -z $first || $(inside systemctl is-system-running 2>/dev/null) != degraded ]] || { inside systemctl --failed --no-legend; break; }
  sleep 1
done
inside systemctl is-system-running
status=0
inside "$@" || status=$?
((status == 0)) || inside journalctl --no-pager -n 60 -u 'axisd*' -u 'vcan*' >&2
exit "$status"
