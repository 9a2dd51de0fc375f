# shellcheck shell=bash
# pcm3680.sh: in a guest with the device pcm3680_pci: its controllers as can0 and can1, by the driver of ISA cards, for Debian's
# kernel has none for this one. The registers are where that driver expects them, at ports that the bus has assigned.
for card in /sys/bus/pci/devices/*; do
  [[ $(<"$card/vendor"):$(<"$card/device") == 0x13fe:0xc002 ]] || continue
  echo 1 >"$card/enable"
  { read -r first _ && read -r second _; } <"$card/resource"
  interrupt=$(<"$card/irq")
  modprobe sja1000_isa port=$((first)),$((second)) irq="$interrupt,$interrupt"
done
