#include <algorithm>
#include <utility>

#include "tests/farm/agent/plan/told_farm.hpp"

namespace told {

namespace {

constexpr Duration kNoticed = 1s;  // after which a connection that is cut is given up
constexpr Duration kBack = 100ms;  // in which it is made again

}  // namespace

Host::Host(Farm& farm, std::string its_name, std::uint32_t its_capacity)
    : name{std::move(its_name)}, capacity{its_capacity}, farm_{farm} {}

bool Host::is_well(Duration since) const {
  return plan != nullptr && !is_cut && farm_.now - well_since_ >= since;
}

void Host::boot() {
  has_door = true;
  door_instance = ++farm_.last_instance;
  start_agent();
}

void Host::start_agent() {
  instance = ++farm_.last_instance * 7919 % 1'000'003 + 1;
  farm::agent::Self self{.host = name, .instance = instance, .version = "1", .since = {}, .capacity = capacity};
  self.buses = buses;
  plan = std::make_unique<farm::agent::Plan>(self, farm_.now);
  for (auto& [unit, state] : units) {
    if (state.state == Unit::State::Stopping) continue;
    state.state = Unit::State::On;
    plan->on_found({unit, state.configuration, folders[unit].kept.term, folders[unit].kept.generation}, farm_.now);
  }
  for (const auto& [unit, state] : units) {
    if (folders[unit].value == 0) continue;
    plan->on_saved(unit, false);
    upload(unit);
  }
  for (const std::string& bus : hubs) plan->hubs().on_found(bus, 0, farm_.now);
  is_down_told_ = true;
  connect_at_ = farm_.now + kBack;
  well_since_ = farm_.now;
}

void Host::kill_agent() {
  plan.reset();
  events_.clear();
}

void Host::kill() {
  kill_agent();
  has_door = false;
  units.clear();
  hubs.clear();
}

void Host::cut() {
  if (std::exchange(is_cut, true)) return;
  cut_since_ = farm_.now;
  is_down_told_ = false;
  connect_at_ = canopen::kNever;
}

/// A break that was not noticed has cost the connection all the same.
void Host::heal() {
  if (!std::exchange(is_cut, false)) return;
  well_since_ = farm_.now;
  connect_at_ = farm_.now + kBack;
}

void Host::kill_unit(const UnitName& unit) {
  if (units.erase(unit) == 0) return;
  is_changed_ = true;
  later_here([unit, &farm = farm_](farm::agent::Plan& it) { it.on_ended(unit, "killed", farm.now); });
}

void Host::save(const UnitName& unit) {
  if (!runs(unit)) return;
  const auto value = static_cast<int>(++farm_.last_instance);
  units.at(unit).value = folders[unit].value = value;
  if (plan == nullptr) return;
  plan->on_saved(unit, false);
  upload(unit);
}

/// As the agent does it: again and again, until it is there or the unit is another's.
void Host::upload(const UnitName& unit) {
  later_here([this, unit](farm::agent::Plan& it) {
    if (is_cut) return upload(unit);
    const farm::Place place = farm_.place(unit);
    if (place.host == name && place.instance == instance) farm_.server.saved[unit] = folders[unit].value;
    it.on_saved(unit, true);
  });
}

void Host::later(std::function<void(farm::agent::Plan&)> what) {
  last_ = std::max(last_, farm_.now + farm_.between(1ms, 40ms));
  events_.push_back({last_, std::move(what), true});
}

void Host::later_here(std::function<void(farm::agent::Plan&)> what) {
  last_ = std::max(last_, farm_.now + farm_.between(1ms, 40ms));
  events_.push_back({last_, std::move(what), false});
}

void Host::tell(Bucket bucket, const farm::Entry& entry) {
  if (plan == nullptr || is_cut || is_down_told_) return;
  later([bucket, entry](farm::agent::Plan& it) { it.on_entry(bucket, entry); });
}

void Host::connect() {
  connect_at_ = canopen::kNever;
  is_down_told_ = false;
  std::erase_if(events_, [](const Event& event) { return event.needs_server; });
  if (plan == nullptr) return;
  plan->on_down();
  plan->on_up(farm_.now);
  for (std::size_t i = 0; i < kBuckets; ++i) {
    const auto bucket = static_cast<Bucket>(i);
    for (const auto& [key, entry] : farm_.server.keys(bucket)) tell(bucket, entry);
    later([this, bucket](farm::agent::Plan& it) { it.on_all(bucket, farm_.now); });
  }
}

void Host::turn() {
  if (is_cut && !is_down_told_ && farm_.now - cut_since_ >= kNoticed) {
    is_down_told_ = true;
    std::erase_if(events_, [](const Event& event) { return event.needs_server; });
    if (plan != nullptr) plan->on_down();
  }
  if (!is_cut && farm_.now >= connect_at_) connect();
  turn_processes();
  bool is_due = plan != nullptr && farm_.now >= plan->due();
  while (plan != nullptr && !events_.empty() && events_.front().time <= farm_.now) {
    const Event event = std::move(events_.front());
    events_.pop_front();
    if (event.needs_server && is_cut) continue;
    event.what(*plan);
    is_due = true;
  }
  if (farm_.now >= next_beat_) beat();
  if (std::exchange(is_changed_, false)) beat_door();
  if (is_due && plan != nullptr) carry_out(plan->advance(farm_.now));
}

void Host::beat() {
  next_beat_ = farm_.now + farm::agent::kBeatPeriod;
  is_changed_ = true;
  if (plan == nullptr || is_cut) return;
  const farm::AgentBeat told = plan->beat(farm_.now);
  for (Host& host : farm_.hosts)
    if (!host.is_cut) host.later([told, &farm = farm_](farm::agent::Plan& it) { it.hear(told, farm.now); });
}

void Host::beat_door() {
  if (!has_door || is_cut) return;
  farm::DoorBeat told{.host = name, .instance = door_instance, .version = "1", .units = {}};
  for (const auto& [unit, state] : units)
    if (state.state != Unit::State::Starting) told.units.push_back({.name = unit, .profile = "s120"});
  for (const UnitName& unit : foreign) told.units.push_back({.name = unit, .profile = "s120"});
  for (Host& host : farm_.hosts)
    if (!host.is_cut) host.later([told, &farm = farm_](farm::agent::Plan& it) { it.hear(told, farm.now); });
}

void Host::turn_processes() {
  for (auto each = units.begin(); each != units.end();) {
    auto& [unit, state] = *each;
    const bool is_over = state.state != Unit::State::On && farm_.now >= state.until;
    if (is_over && state.state == Unit::State::Stopping) {
      later_here(
          [it_is = unit, &farm = farm_](farm::agent::Plan& it) { it.on_ended(it_is, "stopped", farm.now); });
      each = units.erase(each);
      is_changed_ = true;
      continue;
    }
    if (is_over) {
      state.state = Unit::State::On;
      is_changed_ = true;
      later_here([it_is = unit, &farm = farm_](farm::agent::Plan& it) { it.on_started(it_is, farm.now); });
    }
    ++each;
  }
}

void Host::carry_out(const farm::agent::Orders& orders) {
  for (const auto& notice : orders.notices) notices.push_back(notice.text);
  for (const auto& write : orders.places) carry_out(write);
  for (const auto& write : orders.documents)
    later([this, write](farm::agent::Plan&) {
      const auto entry = farm_.server.write(write.bucket, write.key, write.value, 0);
      if (!entry) return;
      for (Host& host : farm_.hosts) host.tell(write.bucket, *entry);
    });
  for (const auto& check : orders.checks)
    later_here([check, this](farm::agent::Plan& it) {
      if (cannot_judge) return it.on_not_judged(check, "no room on the disk", farm_.now);
      it.on_judged(check, check.configuration.find("bad") == std::string::npos ? "" : "no configuration");
    });
  for (const UnitName& unit : orders.stops)
    if (const auto known = units.find(unit); known != units.end())
      known->second.state = Unit::State::Stopping, known->second.until = farm_.now + farm_.between(10ms, 400ms);
    else
      later_here([unit, &farm = farm_](farm::agent::Plan& it) { it.on_ended(unit, "was not there", farm.now); });
  for (const auto& start_of : orders.starts) start(start_of);
  for (const auto& note : orders.notes) folders[note.unit].kept = {note.term, note.generation};
  for (const auto& hub : orders.hub_starts) {
    hubs.insert(hub.bus);
    later_here([bus = hub.bus, &farm = farm_](farm::agent::Plan& it) { it.hubs().on_started(bus, farm.now); });
  }
  for (const auto& bus : orders.hub_stops) {
    hubs.erase(bus);
    later_here([bus, &farm = farm_](farm::agent::Plan& it) { it.hubs().on_ended(bus, "stopped", farm.now); });
  }
  if (!orders.store_again) return;
  for (const auto& [unit, state] : units)
    if (folders[unit].value != 0) upload(unit);
}

/// It is at the server in a moment, and its outcome is here in another one; neither is sure.
void Host::carry_out(const farm::agent::PlaceWrite& write) {
  if (is_cut)
    return later_here([write, &farm = farm_](farm::agent::Plan& it) {
      it.on_written(write, tl::unexpected{std::string{"no connection"}}, farm.now);
    });
  later_here([this, write](farm::agent::Plan&) {
    using Outcome = tl::expected<std::optional<std::uint64_t>, std::string>;
    Outcome outcome = tl::unexpected{std::string{"no answer"}};
    if (!is_cut) {
      const auto entry =
          farm_.server.write(Bucket::Places, write.unit.key(), text_of(write.place), write.revision);
      outcome = entry ? Outcome{entry->revision} : Outcome{std::nullopt};
      if (entry)
        for (Host& host : farm_.hosts) host.tell(Bucket::Places, *entry);
    }
    later_here([this, write, outcome](farm::agent::Plan& it) {
      it.on_written(write, is_cut ? tl::unexpected{std::string{"no answer"}} : outcome, farm_.now);
    });
  });
}

void Host::start(const farm::agent::UnitStart& unit) {
  if (units.contains(unit.unit)) farm_.faults.push_back(unit.unit.text() + " was started twice on " + name);
  ++starts;
  Folder& folder = folders[unit.unit];
  const auto saved = farm_.server.saved.find(unit.unit);
  if (!folder.kept.is_newest_for(unit) && saved != farm_.server.saved.end()) folder.value = saved->second;
  folder.kept = {unit.term, unit.generation};
  if (saved != farm_.server.saved.end() && folder.value < saved->second)
    farm_.faults.push_back(unit.unit.text() + " was started on " + name + " with what it had saved before");
  Unit& state = units[unit.unit];
  state = {Unit::State::Starting, farm_.now + farm_.between(20ms, 300ms), unit.configuration, folder.value};
}

}  // namespace told
