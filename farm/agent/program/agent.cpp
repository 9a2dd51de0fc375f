#include "farm/agent/program/agent.hpp"

#include <optional>
#include <utility>

#include "farm/naming/subjects.hpp"
#include "service/clock.hpp"

namespace farm::agent {

using axisd::read_clock;

Agent::Agent(axisd::ServiceEvents& events, const Assignment& assignment, const axisd::Log& log)
    : farm_{assignment.farm.name},
      host_{assignment.self.host},
      folders_{assignment.folders},
      log_{log},
      plan_{assignment.self, read_clock()},
      beat_{events.timer(
          [](sd_event_source*, std::uint64_t, void* self) noexcept {
            static_cast<Agent*>(self)->beat();
            return 0;
          },
          this)},
      checks_{events, folders_, assignment.units.program, *this},
      state_{events, link_, farm_, folders_, *this},
      hubs_{events, folders_, assignment.hubs, *this},
      units_{events, folders_, assignment.units, state_, *this},
      link_{events, assignment.farm.server, "axisd-agent " + host_, *this} {
  listen();
  for (const Bucket bucket : {Bucket::Units, Bucket::Places, Bucket::Buses, Bucket::Hosts})
    watch(bucket, bucket_name(bucket));
  hubs_.find();
  units_.find();
  beat();
}

std::string Agent::bucket_name(Bucket bucket) const {
  switch (bucket) {
    case Bucket::Units:
      return units_bucket(farm_);
    case Bucket::Places:
      return places_bucket(farm_);
    case Bucket::Buses:
      return buses_bucket(farm_);
    case Bucket::Hosts:
      return hosts_bucket(farm_);
  }
  return {};
}

void Agent::watch(Bucket bucket, const std::string& name) {
  link_.watch(
      name, ">",
      [this, bucket](const Entry& entry) {
        plan_.on_entry(bucket, entry);
        is_due_ = true;
      },
      [this, bucket] {
        plan_.on_all(bucket, read_clock());
        is_due_ = true;
      });
}

/// What is no beat is nobody's.
void Agent::listen() {
  link_.subscribe(all_agents_subject(farm_), [this](const Message& message) {
    if (const auto beat = parse_agent_beat(message.subject, message.data)) plan_.hear(*beat, read_clock());
    is_due_ = true;
  });
  link_.subscribe(all_doors_subject(farm_), [this](const Message& message) {
    if (const auto beat = parse_door_beat(message.subject, message.data)) plan_.hear(*beat, read_clock());
    is_due_ = true;
  });
  link_.subscribe(who_subject(farm_), [this](const Message&) { tell_all(); });
}

void Agent::beat() {
  axisd::ServiceEvents::start(beat_, kBeatPeriod);
  tell_all();
}

void Agent::tell_all() {
  told_ = plan_.beat(read_clock());
  link_.publish(agent_subject(farm_, host_), text_of(told_));
}

void Agent::advance() {
  const canopen::TimePoint now = read_clock();
  if (!is_due_ && now < plan_.due()) return;
  is_due_ = false;
  carry_out(plan_.advance(now));
  AgentBeat beat = plan_.beat(now);
  beat.sent_ms = told_.sent_ms;
  if (beat != told_) tell_all();
}

canopen::TimePoint Agent::due() const noexcept {
  return is_due_ ? canopen::TimePoint{} : plan_.due();
}

void Agent::drain() {
  plan_.drain();
  is_due_ = true;
}

void Agent::carry_out(const Orders& orders) {
  for (const Notice& notice : orders.notices)
    notice.is_warning ? log_.warning("{}", notice.text) : log_.notice("{}", notice.text);
  for (const UnitName& unit : orders.stops) units_.stop(unit);
  for (const std::string& bus : orders.hub_stops) hubs_.stop(bus);
  for (const HubStart& hub : orders.hub_starts) hubs_.start(hub);
  for (const PlaceWrite& place : orders.places) write(place);
  for (const DocumentWrite& document : orders.documents) write(document);
  for (const Check& check : orders.checks) checks_.judge(check);
  for (const UnitStart& unit : orders.starts) units_.start(unit);
  for (const UnitStart& unit : orders.notes) state_.note(unit);
  if (orders.store_again) state_.upload_again();
}

void Agent::write(const PlaceWrite& place) {
  using Revision = std::optional<std::uint64_t>;
  link_.run<Revision>(
      [bucket = places_bucket(farm_), key = place.unit.key(), value = text_of(place.place),
       revision = place.revision](Storage& storage) { return storage.keys.update(bucket, key, value, revision); },
      [this, place](const tl::expected<Revision, std::string>& outcome) {
        plan_.on_written(place, outcome, read_clock());
        is_due_ = true;
      });
}

/// What becomes of it, its bucket tells; the plan orders it again if it is missing still.
void Agent::write(const DocumentWrite& document) {
  using Revision = std::optional<std::uint64_t>;
  link_.run<Revision>(
      [bucket = bucket_name(document.bucket), document](Storage& storage) {
        return storage.keys.update(bucket, document.key, document.value, 0);
      },
      [](const tl::expected<Revision, std::string>&) {});
}

void Agent::on_up() {
  log_.notice("connected: host {} of farm {}", host_, farm_);
  plan_.on_up(read_clock());
  state_.on_up();
  is_due_ = true;
  link_.publish(who_subject(farm_), "{}");
  tell_all();
}

void Agent::on_down(const std::string& why) {
  log_.warning("no connection to the server: {}", why);
  plan_.on_down();
  is_due_ = true;
}

void Agent::on_judged(const Check& check, const std::string& problem) {
  plan_.on_judged(check, problem);
  is_due_ = true;
}

void Agent::on_not_judged(const Check& check, const std::string& why) {
  plan_.on_not_judged(check, why, read_clock());
  is_due_ = true;
}

void Agent::on_unit_found(const UnitStart& unit) {
  plan_.on_found(unit, read_clock());
  log_.notice("{}: goes on, it was here before this agent", unit.unit.text());
  is_due_ = true;
}

void Agent::on_unit_started(const UnitName& unit) {
  plan_.on_started(unit, read_clock());
  log_.info("{}: started", unit.text());
  is_due_ = true;
}

void Agent::on_unit_ended(const UnitName& unit, const std::string& why) {
  plan_.on_ended(unit, why, read_clock());
  log_.info("{}: has ended", unit.text());
  is_due_ = true;
}

void Agent::on_saved(const UnitName& unit, bool is_saved) {
  plan_.on_saved(unit, is_saved);
  is_due_ = true;
}

void Agent::on_hub_found(const std::string& bus, std::uint32_t bit_rate) {
  plan_.hubs().on_found(bus, bit_rate, read_clock());
  is_due_ = true;
}

void Agent::on_hub_started(const std::string& bus) {
  plan_.hubs().on_started(bus, read_clock());
  log_.info("bus {}: its hub serves", bus);
  is_due_ = true;
}

void Agent::on_hub_ended(const std::string& bus, const std::string& why) {
  plan_.hubs().on_ended(bus, why, read_clock());
  log_.notice("bus {}: its hub has ended: {}", bus, why);
  is_due_ = true;
}

void Agent::on_warning(const std::string& text) {
  log_.warning("{}", text);
}

}  // namespace farm::agent
