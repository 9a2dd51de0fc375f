#include "farm/agent/plan/ledger.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace farm::agent {
namespace {

using canopen::TimePoint;

constexpr std::string_view kGenerationKey = "generation";

}  // namespace

bool Ledger::is_complete() const noexcept {
  return std::ranges::all_of(told_, &ToldKeys::is_complete);
}

std::uint32_t Ledger::bit_rate_of(const std::string& bus) const {
  const auto known = buses_.find(bus);
  return known == buses_.end() ? 0 : known->second.settings.bit_rate;
}

bool Ledger::is_draining(const std::string& host) const {
  const auto known = hosts_.find(host);
  return known != hosts_.end() && known->second.settings.drain;
}

void Ledger::on_up() {
  for (ToldKeys& each : told_) each.begin();
  told_generation_.clear();
  for (auto& [unit, record] : units_)
    if (record.known) record.known->revision = 0;
}

void Ledger::on_entry(Bucket bucket, const Entry& entry, Orders& orders) {
  told(bucket).note(entry.key);
  std::erase_if(missing_,
                [&](const DocumentWrite& write) { return write.bucket == bucket && write.key == entry.key; });
  switch (bucket) {
    case Bucket::Units:
      return take_unit(entry, orders);
    case Bucket::Places:
      return take_place(entry, orders);
    case Bucket::Buses:
      return take_settings(buses_, entry, parse_bus_settings, orders);
    case Bucket::Hosts:
      return take_settings(hosts_, entry, parse_host_settings, orders);
  }
}

UnitRecord* Ledger::record_of(const Entry& entry, Orders& orders) {
  const auto unit = parse_unit_key(entry.key);
  if (unit) return &units_[*unit];
  complain(orders, fmt::format("{}: expected a key BUS.NODE: it is left alone", entry.key.substr(0, 64)));
  return nullptr;
}

void Ledger::take_unit(const Entry& entry, Orders& orders) {
  if (entry.key == kGenerationKey) {
    told_generation_ = entry.is_deleted ? "" : entry.value;
    if (is_complete() && !told_generation_.empty()) generation_ = told_generation_;
    return;
  }
  UnitRecord* const record = record_of(entry, orders);
  if (record == nullptr) return;
  if (entry.is_deleted) return record->wish.reset();
  auto content = parse_wanted_unit(entry.key, entry.value);
  Wish wish{.text = entry.value, .revision = entry.revision, .content = {}, .configuration = {}, .problem = {}};
  if (content) {
    wish.configuration = content->configuration.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    wish.content = *std::move(content);
  } else {
    wish.problem = content.error();
  }
  record->wish = std::move(wish);
}

/// One that cannot be read is nobody's.
void Ledger::take_place(const Entry& entry, Orders& orders) {
  UnitRecord* const record = record_of(entry, orders);
  if (record == nullptr) return;
  if (record->known && entry.revision < record->known->revision) return;  // what was written here is newer
  if (entry.is_deleted) {
    record->known = KnownPlace{.place = {}, .revision = entry.revision};
    return;
  }
  auto place = parse_place(entry.key, entry.value);
  if (!place) complain(orders, fmt::format("place of {}", place.error()));
  record->known = KnownPlace{.place = place ? *std::move(place) : Place{}, .revision = entry.revision};
}

/// What cannot be read changes nothing.
template <class Settings, class Parse>
void Ledger::take_settings(ByName<Settings>& known, const Entry& entry, Parse parse, Orders& orders) {
  if (entry.is_deleted) {
    known.erase(entry.key);
    return;
  }
  auto settings = parse(entry.key, entry.value);
  if (!is_name(entry.key))
    return complain(orders, fmt::format("{}: expected a name as key", entry.key.substr(0, 64)));
  if (!settings) return complain(orders, settings.error());
  known[entry.key] = {entry.value, *settings};
}

void Ledger::on_all(Bucket bucket, TimePoint now, Orders& orders) {
  const bool was_complete = is_complete();
  told(bucket).complete();
  if (!was_complete && is_complete()) settle(now, orders);
}

void Ledger::settle(TimePoint now, Orders& orders) {
  const bool is_new = !generation_.empty() && told_generation_ != generation_;
  std::vector<DocumentWrite> missing;
  settle_units(is_new, missing);
  settle_places(is_new);
  settle_settings(buses_, Bucket::Buses, is_new, missing);
  settle_settings(hosts_, Bucket::Hosts, is_new, missing);
  if (is_new)
    orders.notices.push_back(
        {true, fmt::format("the server has lost the documents of the farm: {} are put back", missing.size())});
  orders.store_again = orders.store_again || is_new;
  if (told_generation_.empty())
    missing.push_back(
        {Bucket::Units, std::string{kGenerationKey}, fmt::format("{}-{}", self_.instance, ++generations_)});
  else
    generation_ = told_generation_;
  missing_ = std::move(missing);
  again_ = now;
  on_time(now, orders);
}

bool Ledger::is_lost(Bucket bucket, const std::string& key, bool is_new) {
  const auto is_it = [&](const DocumentWrite& write) { return write.bucket == bucket && write.key == key; };
  return !told(bucket).has(key) && (is_new || std::ranges::any_of(missing_, is_it));
}

void Ledger::settle_units(bool is_new, std::vector<DocumentWrite>& missing) {
  for (auto& [unit, record] : units_) {
    if (!record.wish || told(Bucket::Units).has(unit.key())) continue;
    if (is_lost(Bucket::Units, unit.key(), is_new))
      missing.push_back({Bucket::Units, unit.key(), record.wish->text});
    else
      record.wish.reset();
  }
}

/// The own ones are put back by whoever writes places; those of others by these.
void Ledger::settle_places(bool is_new) {
  for (auto& [unit, record] : units_) {
    const bool is_gone = record.known && !told(Bucket::Places).has(unit.key());
    if (is_gone && !(is_new && self_.has(record.known->place))) record.known.reset();
  }
}

template <class Settings>
void Ledger::settle_settings(ByName<Settings>& known, Bucket bucket, bool is_new,
                             std::vector<DocumentWrite>& missing) {
  for (const auto& [name, kept] : known)
    if (is_lost(bucket, name, is_new)) missing.push_back({bucket, name, kept.text});
  std::erase_if(known, [&](const auto& each) {
    return !told(bucket).has(each.first) && !is_lost(bucket, each.first, is_new);
  });
}

void Ledger::on_time(TimePoint now, Orders& orders) {
  if (now < due() || missing_.empty()) return;
  orders.documents.insert(orders.documents.end(), missing_.begin(), missing_.end());
  again_ = now + kFirstPause;
}

/// Once for each text, however often it is told.
void Ledger::complain(Orders& orders, std::string text) {
  constexpr std::size_t kMost = 1000;
  if (complaints_.size() < kMost && complaints_.insert(text).second)
    orders.notices.push_back({true, std::move(text)});
}

}  // namespace farm::agent
