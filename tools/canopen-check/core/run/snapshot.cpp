#include "tools/canopen-check/core/run/snapshot.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint16_t kPdoMask = 0xFC00;
constexpr std::uint16_t kMappingOffset = 0x200;

bool belongs_to_pdo(std::uint16_t index) noexcept {
  return index >= object::kRpdoParameter && index < object::kPdosEnd;
}

/// Communication parameters that @p index, these or a mapping, belongs to.
std::uint16_t parameters_of(std::uint16_t index) noexcept {
  return static_cast<std::uint16_t>((index & kPdoMask) | (index & (kMappingOffset - 1)));
}

}  // namespace

Snapshot::Snapshot(SdoClient& sdo, const eds::Description& eds, const Settings& settings) : sdo_{&sdo} {
  for (const eds::EntryFacts& entry : eds.entries()) {
    const bool kept = entry.readable() && entry.writable() && !entry.no_read && entry.numeric() &&
                      write_refusal(entry, settings) == nullptr;
    if (!kept) continue;
    SdoAnswer answer = sdo.upload(entry.index, entry.sub_index);
    if (answer.kind == SdoAnswer::Kind::Silent) break;
    if (answer.done()) values_.emplace(Entry{entry.index, entry.sub_index}, std::move(answer.data));
  }
}

std::vector<Entry> Snapshot::changed() {
  std::vector<Entry> others;
  for (const auto& [entry, before] : not_seen_in(*sdo_, values_)) {
    const SdoAnswer now = sdo_->upload(entry.first, entry.second);
    if (!now.done() || now.data != before) others.push_back(entry);
    if (now.kind == SdoAnswer::Kind::Silent) break;
  }
  return others;
}

void Snapshot::write_back(std::uint16_t index, std::uint8_t sub_index) {
  if (const auto value = values_.find({index, sub_index}); value != values_.end())
    (void)sdo_->download(index, sub_index, value->second);
}

void Snapshot::restore_pdo(std::uint16_t parameters) {
  constexpr std::uint8_t kHighest = 0x40;
  const auto mapping = static_cast<std::uint16_t>(parameters + kMappingOffset);
  const auto cob_id = values_.find({parameters, 1});
  if (cob_id == values_.end()) return;
  Bytes invalid = cob_id->second;
  if (!invalid.empty()) invalid.back() |= 0x80U;
  (void)sdo_->download(parameters, 1, invalid);
  (void)sdo_->download(mapping, 0, Bytes{0});
  for (std::uint8_t sub = 1; sub <= kHighest; ++sub) write_back(mapping, sub);
  write_back(mapping, 0);
  for (std::uint8_t sub = 2; sub <= 6; ++sub) write_back(parameters, sub);
  write_back(parameters, 1);
}

std::vector<std::string> Snapshot::restore() {
  std::vector<Entry> entries = changed();
  // A value may be refused until another one is back.
  for (int pass = 0; pass < 3 && !entries.empty(); ++pass) {
    std::set<std::uint16_t> pdos;
    for (const auto& [index, sub_index] : entries) {
      if (belongs_to_pdo(index)) {
        pdos.insert(parameters_of(index));
      } else {
        write_back(index, sub_index);
      }
    }
    for (const std::uint16_t parameters : pdos) restore_pdo(parameters);
    entries = changed();
  }
  std::vector<std::string> left;
  for (const Entry& entry : entries)
    left.push_back(
        fmt::format("{:04X}h:{:02X} held {} before", entry.first, entry.second, hexadecimal(values_.at(entry))));
  return left;
}

}  // namespace conformance
