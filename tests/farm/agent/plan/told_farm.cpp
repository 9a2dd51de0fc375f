#include "tests/farm/agent/plan/told_farm.hpp"

#include <algorithm>

namespace told {

namespace {

constexpr Duration kStep = 10ms;

}  // namespace

Host& Farm::add(const std::string& name, std::uint32_t capacity) {
  Host& host = hosts.emplace_back(*this, name, capacity);
  host.boot();
  return host;
}

void Farm::pass(Duration time) {
  for (const TimePoint end = now + time; now < end;) {
    now += kStep;
    for (Host& host : hosts) host.turn();
    if (const std::string line = doubles(); !line.empty()) faults.push_back(line);
  }
}

bool Farm::pass_until(const std::function<bool()>& condition, Duration limit) {
  for (const TimePoint end = now + limit; now < end; pass(kStep))
    if (condition()) return true;
  return condition();
}

void Farm::want(const UnitName& unit, const std::string& document) {
  put(Bucket::Units, unit.key(), document);
}

void Farm::put(Bucket bucket, const std::string& key, const std::string& value) {
  const auto entry = server.write(bucket, key, value, std::nullopt);
  for (Host& host : hosts) host.tell(bucket, *entry);
}

void Farm::remove(Bucket bucket, const std::string& key) {
  const auto entry = server.write(bucket, key, "", std::nullopt, true);
  for (Host& host : hosts) host.tell(bucket, *entry);
}

void Farm::lose_server() {
  server.lose();
  for (Host& host : hosts) {
    host.cut();
    host.heal();
  }
}

farm::Place Farm::place(const UnitName& unit) const {
  const auto& keys = server.keys(Bucket::Places);
  const auto entry = keys.find(unit.key());
  return entry == keys.end() ? farm::Place{} : farm::parse_place(unit.key(), entry->second.value).value();
}

std::vector<std::string> Farm::hosts_of(const UnitName& unit) const {
  std::vector<std::string> found;
  for (const Host& host : hosts)
    if (host.runs(unit)) found.push_back(host.name);
  return found;
}

std::string Farm::doubles() const {
  constexpr Duration kGrace = 800ms;  // to be told what has changed, and to stop what is another's
  std::map<UnitName, std::string> seen;
  for (const Host& host : hosts) {
    if (!host.is_well(kGrace)) continue;
    for (const auto& [unit, state] : host.units)
      if (const auto [other, is_first] = seen.emplace(unit, host.name); !is_first)
        return unit.text() + " runs on " + other->second + " and on " + host.name;
  }
  return {};
}

}  // namespace told
