#!/usr/bin/env bash
# check_unit.sh verify FOLDER UNIT            the unit has no error, and no warning either
# check_unit.sh exposure FOLDER UNIT LIMIT    its exposure, times ten, is at most LIMIT; prints the exposure
# check_unit.sh limits FOLDER UNIT            memory and tasks are bounded, and systemd understands the bounds
# check_unit.sh says FOLDER UNIT TEXT...      systemd-analyze says each TEXT of it
# check_unit.sh sharing FOLDER UNIT            its user is made at run time, its group is that of the control sockets, its own
#                                            folders are within nobody else's
# A template is checked as the instance vcan0.
set -euo pipefail

mode=$1 folder=$2 unit=$3
command -v systemd-analyze >/dev/null || { echo "systemd-analyze is missing: apt-get install systemd" >&2; exit 1; }
instance=${unit/@./@vcan0.}

case $mode in
  verify)
    # The trailing colon adds systemd's own units, such as modprobe@.service.
    answer=$(SYSTEMD_UNIT_PATH=$folder: systemd-analyze verify --man=no "$instance" 2>&1) ||
      { echo "$answer" >&2; exit 1; }
    # systemd-analyze reports an unknown setting and still succeeds. What it says of other units is not about ours.
    if grep -F "${unit%.service}" <<<"$answer" >&2; then exit 1; fi ;;
  exposure)
    SYSTEMD_UNIT_PATH=$folder: systemd-analyze security --offline=true --threshold="$4" --no-pager "$folder/$unit" ;;
  limits)
    for limit in MemoryMax TasksMax; do
      value=$(sed -n "s/^$limit=//p" "$folder/$unit")
      [[ $value =~ ^[0-9]+[MG]?$ ]] || { echo "$unit: expected $limit=NUMBER, got '$value'" >&2; exit 1; }
    done ;;
  says)
    answer=$(SYSTEMD_UNIT_PATH=$folder: systemd-analyze security --offline=true --threshold=100 --no-pager "$folder/$unit")
    for wanted in "${@:4}"; do
      grep -qF "$wanted" <<<"$answer" || { echo "$unit: systemd-analyze does not say '$wanted'" >&2; exit 1; }
    done ;;
  sharing)
    setting() { sed -n "s/^$1=//p" "$folder/$unit"; }
    [[ $(setting DynamicUser) == yes && $(setting Group) == axisd ]] || { echo "$unit: expected DynamicUser=yes, Group=axisd" >&2; exit 1; }
    # A group that exists and a user that does not may not have one name.
    [[ $(setting User) == _* ]] || { echo "$unit: expected a user other than the group, got '$(setting User)'" >&2; exit 1; }
    # systemd gives a folder and all below it to the service, and deletes /run/FOLDER when that ends.
    for other in "$folder"/*.service; do
      [[ $other != "$folder/$unit" ]] || continue
      for name in StateDirectory RuntimeDirectory; do
        own=$(setting $name) theirs=$(sed -n "s/^$name=//p" "$other")
        [[ -z $own || $theirs/ != "$own"/* ]] || { echo "$unit: $name=$own holds that of ${other##*/}" >&2; exit 1; }
      done
    done ;;
  *) echo "unknown mode $mode" >&2; exit 2 ;;
esac
