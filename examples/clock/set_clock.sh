#!/bin/sh
# set_clock.sh INTERFACE NODE-ID [simple|ping-snap]: gives a drive unit the UTC time of this machine, with cansend.
# Ping-snap uses bit 11 of the controlword of the first axis and sends RPDO 1 with nothing else set: it is for an axis
# that stands still. NODE-ID is that of the unit in decimal.
set -eu

interface=$1 request=$(printf '6%02X' "$2") command=$(printf '2%02X' "$2") node=$(printf '%02X' "$2")
method=${3:-simple}

# Milliseconds since 1970, in two numbers: days and milliseconds of the day.
now() { date +%s%3N; }
day=86400000

# The bytes of a number of 32 bits, the least significant first.
bytes() { printf '%02X%02X%02X%02X' $(($1 & 255)) $(($1 >> 8 & 255)) $(($1 >> 16 & 255)) $(($1 >> 24 & 255)); }

write_u16() { cansend "$interface" "$request#2B$1$(bytes "$2")"; }
write_u32() { cansend "$interface" "$request#23$1$(bytes "$2")"; }
pause() { sleep 0.1; } # one SDO transfer at a time

# Object and sub-index as they stand in a frame.
window=B64100 mode=1C2C00 milliseconds=1D2C00 days=1D2C01 method_of=1F2C00 ping=202C00

write_u16 $window 1 && pause # p8630[0]: 2000h + number is a parameter of the control unit
write_u16 $mode 1 && pause   # p3100: UTC
case $method in
simple)
  write_u16 $method_of 2 && pause # p3103
  write_u32 $days $(($(now) / day)) && pause
  write_u32 $milliseconds $(($(now) % day))
  ;;
ping-snap)
  write_u16 $method_of 0 && pause                                         # p3103
  write_u32 $ping $((0x22BA080B)) && pause                                # p3104 = r8890.11 of drive object 2
  cansend "$interface" "000#01$node" && pause                             # NMT: Operational, for the RPDO
  cansend "$interface" "$command#0000" && pause
  pinged=$(now)
  cansend "$interface" "$command#0008" && pause                           # the ping: bit 11 rises
  write_u32 $days $((pinged / day)) && pause
  write_u32 $milliseconds $((pinged % day)) && pause                      # the snap: so late was it then
  cansend "$interface" "$command#0000"
  ;;
*)
  echo "set_clock.sh: $method: expected simple or ping-snap" >&2
  exit 2
  ;;
esac
