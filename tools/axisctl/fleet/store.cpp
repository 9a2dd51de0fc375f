#include "tools/axisctl/fleet/store.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "farm/documents/settings.hpp"
#include "farm/naming/subjects.hpp"

namespace fleet {
namespace {

using farm::Entry;
using farm::KeyValue;
using farm::UnitName;

/// How often a document is changed again that somebody else has changed meanwhile.
constexpr int kMostTries = 5;

/// Puts @p texts, by their keys, into @p bucket; what became of them, in their order.
Stored<std::vector<Effect>> put_all(KeyValue& keys, const std::string& bucket,
                                    const std::vector<std::pair<std::string, std::string>>& texts) {
  const auto present = keys.all(bucket);
  if (!present) return tl::unexpected{present.error()};
  std::map<std::string, std::string> before;
  for (const Entry& entry : *present) before[entry.key] = entry.value;
  std::vector<Effect> effects;
  for (const auto& [key, text] : texts) {
    const auto known = before.find(key);
    const Effect effect = known == before.end()   ? Effect::Created
                          : known->second == text ? Effect::Unchanged
                                                  : Effect::Changed;
    effects.push_back(effect);
    if (effect == Effect::Unchanged) continue;
    if (const auto written = keys.put(bucket, key, text); !written) return tl::unexpected{written.error()};
  }
  return effects;
}

}  // namespace

std::string_view text_of(Effect effect) noexcept {
  static constexpr std::array<std::string_view, 3> kTexts{"created", "changed", "unchanged"};
  return kTexts[static_cast<std::size_t>(effect)];
}

/// Buses first: a unit that is started finds its bus as it is to be.
Stored<Applied> apply(farm::Storage& storage, const std::string& farm, const WantedFleet& wanted) {
  std::vector<std::pair<std::string, std::string>> buses;
  for (const auto& [name, settings] : wanted.buses) buses.emplace_back(name, farm::text_of(settings));
  std::vector<std::pair<std::string, std::string>> units;
  for (const auto& [name, unit] : wanted.units) units.emplace_back(name.key(), farm::text_of(unit));
  Applied applied;
  const auto of_buses = put_all(storage.keys, farm::buses_bucket(farm), buses);
  if (!of_buses) return tl::unexpected{of_buses.error()};
  const auto of_units = put_all(storage.keys, farm::units_bucket(farm), units);
  if (!of_units) return tl::unexpected{of_units.error()};
  for (const auto& [name, settings] : wanted.buses)
    applied.buses.emplace_back(name, of_buses->at(applied.buses.size()));
  for (const auto& [name, unit] : wanted.units)
    applied.units.emplace_back(name.text(), of_units->at(applied.units.size()));
  return applied;
}

Stored<std::map<UnitName, KnownUnit>> read(farm::Storage& storage, const std::string& farm) {
  const auto wanted = storage.keys.all(farm::units_bucket(farm));
  if (!wanted) return tl::unexpected{wanted.error()};
  const auto places = storage.keys.all(farm::places_bucket(farm));
  if (!places) return tl::unexpected{places.error()};
  std::map<UnitName, KnownUnit> units;
  for (const Entry& entry : *wanted) {
    const auto name = farm::parse_unit_key(entry.key);
    if (!name) continue;
    auto unit = farm::parse_wanted_unit(entry.key, entry.value);
    if (unit)
      units[*name].wanted = *std::move(unit);
    else
      units[*name].wrong = unit.error();
  }
  for (const Entry& entry : *places) {
    const auto name = farm::parse_unit_key(entry.key);
    const auto place = farm::parse_place(entry.key, entry.value);
    if (!name || !place || (place->host.empty() && !units.contains(*name))) continue;
    units[*name].place = *place;
  }
  return units;
}

Stored<std::vector<std::string>> remove(farm::Storage& storage, const std::string& farm,
                                        const std::vector<UnitName>& units,
                                        const std::vector<std::string>& buses) {
  const std::string bucket = farm::units_bucket(farm);
  const auto present = storage.keys.all(bucket);
  if (!present) return tl::unexpected{present.error()};
  std::vector<std::string> removed;
  for (const Entry& entry : *present) {
    const auto name = farm::parse_unit_key(entry.key);
    if (!name) continue;
    if (std::ranges::find(units, *name) == units.end() && std::ranges::find(buses, name->bus) == buses.end())
      continue;
    if (const auto done = storage.keys.remove(bucket, entry.key); !done) return tl::unexpected{done.error()};
    removed.push_back(name->text());
  }
  return removed;
}

Stored<bool> move(farm::Storage& storage, const std::string& farm, const UnitName& unit, const std::string& host) {
  const std::string bucket = farm::units_bucket(farm);
  for (int tries = 0; tries < kMostTries; ++tries) {
    const auto entry = storage.keys.get(bucket, unit.key());
    if (!entry) return tl::unexpected{entry.error()};
    if (!*entry) return false;
    auto wanted = farm::parse_wanted_unit(unit.key(), (*entry)->value);
    if (!wanted) return tl::unexpected{wanted.error()};
    wanted->hosts = {host};
    const auto written = storage.keys.update(bucket, unit.key(), farm::text_of(*wanted), (*entry)->revision);
    if (!written) return tl::unexpected{written.error()};
    if (*written) return true;
  }
  return tl::unexpected{fmt::format("{}: somebody else changes it all the time", unit.text())};
}

Stored<bool> drain(farm::Storage& storage, const std::string& farm, const std::string& host, bool drain) {
  const std::string bucket = farm::hosts_bucket(farm);
  if (drain)
    return storage.keys.put(bucket, host, farm::text_of(farm::HostSettings{.drain = true})).map([](std::uint64_t) {
      return true;
    });
  return storage.keys.remove(bucket, host).map([] { return true; });
}

}  // namespace fleet
