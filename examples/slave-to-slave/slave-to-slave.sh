#!/bin/sh
# One unit follows the actual speed of another, over the CAN bus alone: an RPDO of the follower listens to a TPDO of
# the leader. usage: slave-to-slave.sh INTERFACE [LEADER FOLLOWER]; needs candump and cansend.
set -eu
interface=$1 leader=${2:-5} follower=${3:-6}

send() { cansend "$interface" "$1"; sleep 0.02; }
# A number of 1, 2 or 4 bytes as CAN data, the least significant byte first.
bytes() {
  case $1 in
    1) printf '%02X' "$2" ;;
    2) printf '%02X%02X' $(($2 & 255)) $(($2 >> 8 & 255)) ;;
    4) printf '%02X%02X%02X%02X' $(($2 & 255)) $(($2 >> 8 & 255)) $(($2 >> 16 & 255)) $(($2 >> 24 & 255)) ;;
  esac
}
# sdo NODE INDEX SUB SIZE VALUE: writes an object.
sdo() {
  case $4 in 1) command=2F ;; 2) command=2B ;; 4) command=23 ;; esac
  padding=$(printf '00%.0s' $(seq $((4 - $4))))
  [ "$4" = 4 ] && padding=
  send "$(printf '%03X#%s%s%02X%s%s' $((0x600 + $1)) $command "$(bytes 2 "$2")" "$3" "$(bytes "$4" "$5")" "$padding")"
}
# parameter NODE DRIVE_OBJECT NUMBER INDEX VALUE: writes a parameter of 32 bits through the window of p8630.
parameter() {
  sdo "$1" $((0x2000 + 8630)) 0 2 "$2"
  sdo "$1" $((0x2000 + $3)) "$4" 4 "$5"
}
# source NUMBER INDEX: a connector of the own drive object.
source_of() { echo $(($1 << 16 | 63 << 10 | $2)); }
controlword() { send "$(printf '%03X#%s' $((0x200 + $1)) "$(bytes 2 "$2")")"; }

axis=2            # its drive object
cob_id=$((0x380 + leader))

# Leader: TPDO3 carries the free object 5810h, which shows the actual speed (r0063; 4000h = p2000).
sdo "$leader" 0x1802 1 4 $((0x80000000 | cob_id))   # not valid while it is mapped
sdo "$leader" 0x1A02 0 1 0
sdo "$leader" 0x1A02 1 4 $((0x58100010))
sdo "$leader" 0x1A02 0 1 1
sdo "$leader" 0x1802 2 1 255                         # when it changes
sdo "$leader" 0x1802 3 2 100                         # at most every 10 ms
sdo "$leader" 0x1802 1 4 "$cob_id"
parameter "$leader" $axis 8851 3 "$(source_of 63 0)"

# Follower: RPDO3 listens to it; its word is the main setpoint.
sdo "$follower" 0x1402 1 4 $((0x80000000 | cob_id))
sdo "$follower" 0x1602 0 1 0
sdo "$follower" 0x1602 1 4 $((0x58000010))
sdo "$follower" 0x1602 0 1 1
sdo "$follower" 0x1402 2 1 255
sdo "$follower" 0x1402 1 4 "$cob_id"
parameter "$follower" $axis 1070 0 "$(source_of 8850 3)"

send 000#0100                                        # NMT: both to Operational
for word in 6 7 15; do controlword "$leader" $word; controlword "$follower" $word; sleep 0.1; done
# The leader turns at 750 rpm: 52428800 increments a second.
send "$(printf '%03X#%s%s' $((0x300 + leader)) "$(bytes 2 15)" "$(bytes 4 52428800)")"
