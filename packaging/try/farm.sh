# shellcheck shell=bash
# The services of a farm, with a server on this machine; to be sourced by services.sh, whose functions it uses.
install_packages nats-server
systemctl disable --now nats-server 2>/dev/null || true
systemd-run --quiet --unit=try-nats nats-server -js -sd /run/try/nats -a 127.0.0.1
farm=nats://127.0.0.1/lab
on_farm() { axisctl --farm "$farm" "$@"; }
farm_log() { journalctl --no-pager -n 30 -u axisd-agent -u axisd-nats -u try-nats; }
unit_of_farm() { pgrep -f '^/usr/bin/axisd .*/axisd/agent/'; }

for service in agent nats; do
  echo "AXISD_${service^^}_OPTIONS=\"--farm $farm --host here\"" >"/etc/default/axisd-$service"
  systemctl enable --now "axisd-$service"
  expect_active "axisd-$service"
done
echo '{"units": [{"bus": "cell", "node_id": 5}]}' >/run/try/farm.json
within 60 on_farm fleet apply /run/try/farm.json || fail "no unit can be wanted: $(farm_log)"
within 120 on_farm --unit cell/5 set 1/p1120 2.5 >/dev/null || fail "the unit of the farm does not answer: $(farm_log)"
on_farm fleet list
ps -o user:20,group:20,args -C axisd-agent,axisd-nats,axisd

# A unit goes on without its agent, and the next one has it.
before=$(unit_of_farm)
systemctl restart axisd-agent
expect_active axisd-agent
[[ $(unit_of_farm) == "$before" ]] || fail "the unit was started again: $(farm_log)"
within 60 on_farm --unit cell/5 get 1/p1120 || fail "the unit is not reached any more: $(farm_log)"
on_farm --unit cell/5 store >/dev/null
echo "-- a farm of one host"

# What the administrator has written, he removes.
rm /etc/default/axisd-{agent,nats}
