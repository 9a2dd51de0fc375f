#include "farm/mirror/directory.hpp"

#include <algorithm>
#include <utility>

namespace farm {
namespace {

constexpr std::size_t kMostHosts = 1024;

bool are_alike(const Directory::Entry& one, const Directory::Entry& other) {
  return one.unit == other.unit;
}

}  // namespace

bool Directory::take(const DoorBeat& beat, Instant now) {
  if (hosts_.size() >= kMostHosts && !hosts_.contains(beat.host)) return false;
  Host& host = hosts_[beat.host];
  const bool was_silent = host.heard == Instant{} || is_silent(host, now);
  host.heard = now;
  host.is_silent = false;
  if (host.instance != beat.instance || host.parts.contains(beat.part)) host.coming.clear(), host.parts.clear();
  host.instance = beat.instance;
  host.parts.insert(beat.part);
  for (const DoorUnit& unit : beat.units) {
    const auto known = host.units.find(unit.name);
    const Instant since = known == host.units.end() ? now : known->second.since;
    host.coming.insert_or_assign(unit.name, Entry{beat.host, unit, since});
  }
  if (host.parts.size() < beat.parts) return was_silent && !host.units.empty();
  host.parts.clear();
  const bool is_same = std::ranges::equal(host.units, host.coming, [](const auto& one, const auto& other) {
    return are_alike(one.second, other.second);
  });
  host.units = std::exchange(host.coming, {});
  return was_silent || !is_same;
}

tl::expected<Directory::Entry, Absence> Directory::find(const UnitName& unit, Instant now) const {
  const Entry* present = nullptr;
  Absence absence;
  for (const auto& [name, host] : hosts_) {
    const auto found = host.units.find(unit);
    if (found == host.units.end()) continue;
    if (is_silent(host, now))
      absence = {name, now - host.heard};
    else if (present == nullptr || present->since < found->second.since)
      present = &found->second;
  }
  if (present != nullptr) return *present;
  return tl::unexpected{std::move(absence)};
}

std::vector<Directory::Entry> Directory::units(Instant now) const {
  Units all;
  for (const auto& [name, host] : hosts_) {
    if (is_silent(host, now)) continue;
    for (const auto& [unit, entry] : host.units) {
      const auto [place, is_new] = all.try_emplace(unit, entry);
      if (!is_new && place->second.since < entry.since) place->second = entry;
    }
  }
  std::vector<Entry> list;
  for (auto& [unit, entry] : all) list.push_back(std::move(entry));
  return list;
}

std::vector<std::string> Directory::take_silent(Instant now) {
  std::vector<std::string> names;
  for (auto& [name, host] : hosts_) {
    if (host.is_silent || !is_silent(host, now)) continue;
    host.is_silent = true;
    names.push_back(name);
  }
  return names;
}

}  // namespace farm
