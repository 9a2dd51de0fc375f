#!/usr/bin/env bash
# Prints every file of the root, but what dpkg, apt, the loader, groupadd and useradd keep of themselves, and what lies there for the trial.
find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /run -o -path /tmp -o -path /packages -o -path /before -o -path /try \
  -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache -o -path /var/log -o -path /etc/group- -o -path /etc/gshadow- -o -path /etc/passwd- \
  -o -path /etc/shadow- \
  -o -name 'try.*' \) -prune -o -print | LC_ALL=C sort
dpkg-query -W -f '${Package} ${Status}\n'
