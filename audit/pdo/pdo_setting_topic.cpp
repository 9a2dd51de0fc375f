#include "audit/pdo/pdo_setting_topic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "audit/base/transfer.hpp"
#include "audit/pdo/pdo_rules.hpp"
#include "libcanopen/od/abort_code.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace rules = pdo_rules;

namespace {

constexpr unsigned kMostBits = 64;
constexpr std::uint64_t kFirstReservedType = 241, kLastReservedType = 251, kLastRemoteType = 253;

bool is_aborted_by(const Transfer& transfer, canopen::AbortCode code) noexcept {
  return transfer.end == Transfer::End::AbortedByServer && transfer.abort_code == static_cast<std::uint32_t>(code);
}

/// Whether @p at decides whose frames a PDO is, when it acts, or what is in it.
bool is_essential(const canopen::sdo::Address& at, const PdoRecord& record) noexcept {
  return at.index == record.mapping() || at.sub_index == kCobIdSub || at.sub_index == kTypeSub;
}

void add(const Rule& rule, const Transfer& transfer, const Scene& scene, const std::string& text) {
  scene.findings.add(rule, transfer.channel.node, {transfer.request, transfer.last}, [&] { return text; });
}

}  // namespace

void PdoSettingTopic::on_frame(const Passage& passage, const Scene& scene) {
  const canopen::Frame& frame = passage.frame();
  if (passage.is_boot_up()) return forget(passage.meaning.node);
  if (passage.is_start()) start(frame.data[1], passage.heard, scene);
  if (passage.is_reset()) forget(frame.data[1]);
}

/// @p node (0: each) is started.
void PdoSettingTopic::start(std::uint8_t node, const Heard& heard, const Scene& scene) {
  std::erase_if(in_work_, [&](const auto& item) {
    const bool is_meant = node == 0 || node == item.first.first;
    if (is_meant)
      scene.findings.add(rules::kLeftInvalid, item.first.first, {item.second, heard},
                         [&] { return name_of(item.first.second); });
    return is_meant;
  });
}

/// @p node (0: each) has its PDOs as they were stored.
void PdoSettingTopic::forget(std::uint8_t node) {
  const auto is_meant = [node](const auto& item) { return node == 0 || node == item.first.first; };
  std::erase_if(in_work_, is_meant);
  std::erase_if(refused_, is_meant);
  std::erase_if(changed_, [node](const Place& place) { return node == 0 || node == place.first; });
}

void PdoSettingTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  const auto record = pdo_at(transfer.at.index);
  if (!record || !transfer.is_write) return;
  const Node& node = scene.network.node(transfer.channel.node);
  if (node.state == canopen::NmtState::Operational && is_essential(transfer.at, *record))
    add(rules::kInOperational, transfer, scene, meaning::name_of(transfer.at, node.description));
  if (transfer.at.index == record->communication())
    take_communication(transfer, *record, scene);
  else
    take_mapping(transfer, *record, scene);
  if (transfer.at.index == record->mapping()) note_refused(transfer, *record, scene);
}

/// A step that is refused is made good by itself, later, or by a mapping that begins anew.
void PdoSettingTopic::note_refused(const Transfer& transfer, const PdoRecord& record, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  if (transfer.end == Transfer::End::AbortedByServer && is_valid(node, record) == false)
    refused_[{node.id, record}] = transfer.last;
  const auto refused = refused_.find({node.id, record});
  if (!transfer.is_done() || refused == refused_.end()) return;
  const auto at = canopen::sdo::address_in(refused->second.frame);
  const bool is_anew = transfer.at.sub_index == 0 && transfer.value == 0;
  if (is_anew || at.sub_index == transfer.at.sub_index) refused_.erase(refused);
}

void PdoSettingTopic::take_communication(const Transfer& transfer, const PdoRecord& record, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  const std::uint64_t last_type = record.is_receive ? kLastRemoteType : kLastReservedType;
  switch (transfer.at.sub_index) {
    case kCobIdSub:
      return take_cob_id(transfer, record, scene);
    case kTypeSub:
      if (transfer.value >= kFirstReservedType && transfer.value <= last_type)
        add(rules::kReservedType, transfer, scene, fmt::format("{}: type {}", name_of(record), transfer.value));
      return;
    case kInhibitSub:
      if (is_valid(node, record) == true && node.value(record.communication(), kInhibitSub) != transfer.value)
        add(rules::kInhibitWhileValid, transfer, scene, name_of(record));
      return;
    default:
      return;
  }
}

void PdoSettingTopic::take_cob_id(const Transfer& transfer, const PdoRecord& record, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  const auto cob_id = static_cast<std::uint32_t>(transfer.value);
  const bool stays_valid = is_valid(node, record) == true && (cob_id & canopen::cob_id::kInvalid) == 0;
  const auto before = node.value(record.communication(), kCobIdSub);
  if (stays_valid && canopen::identifier_in(cob_id) != canopen::identifier_in(static_cast<std::uint32_t>(*before)))
    add(rules::kCobIdWhileValid, transfer, scene,
        fmt::format("{}: {:03X}h instead of {:03X}h", name_of(record), canopen::identifier_in(cob_id),
                    canopen::identifier_in(static_cast<std::uint32_t>(*before))));
  else if (canopen::valid_identifier(cob_id) != 0 && !canopen::is_assignable(cob_id, true))
    add(rules::kRestricted, transfer, scene,
        fmt::format("{}: {:03X}h", name_of(record), canopen::identifier_in(cob_id)));
  if (!transfer.is_done()) return;
  const auto refused = refused_.find({node.id, record});
  const bool is_in_use = (cob_id & canopen::cob_id::kInvalid) == 0;
  if (is_in_use && refused != refused_.end())
    scene.findings.add(rules::kRefused, node.id, {refused->second, transfer.request},
                       [&] { return name_of(record); });
  in_work_.erase({node.id, record});  // not in use is decided, too
  if (is_in_use) changed_.erase({node.id, record});
  if (!is_in_use && is_valid(node, record) == true) changed_.insert({node.id, record});
  if (refused != refused_.end()) refused_.erase(refused);
}

void PdoSettingTopic::take_mapping(const Transfer& transfer, const PdoRecord& record, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  const std::string object = meaning::name_of(transfer.at, node.description);
  if (is_valid(node, record) == true) return add(rules::kMappingWhileValid, transfer, scene, object);
  if (transfer.at.sub_index == 0) return take_count(transfer, record, scene);
  const auto count = node.value(record.mapping(), 0);
  if (count.value_or(0) != 0) return add(rules::kMappingCounted, transfer, scene, object);
  if (transfer.is_done() && node.value(record.mapping(), transfer.at.sub_index) != transfer.value)
    changed_.insert({node.id, record});
  if (is_aborted_by(transfer, canopen::AbortCode::NotMappable))
    return add(rules::kNotMappable, transfer, scene, fmt::format("{}: {:08X}h", name_of(record), transfer.value));
}

void PdoSettingTopic::take_count(const Transfer& transfer, const PdoRecord& record, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  if (transfer.value > kMostBits) return;  // a multiplexed PDO
  unsigned bits = 0;
  bool is_known = true;
  for (std::uint64_t i = 1; i <= transfer.value; ++i) {
    const auto entry = node.value(record.mapping(), static_cast<std::uint8_t>(i));
    if (entry == 0)
      return add(rules::kMappingBeyond, transfer, scene,
                 fmt::format("{}: {} entries, and none at sub-index {}", name_of(record), transfer.value, i));
    is_known = is_known && entry;
    bits += static_cast<unsigned>(entry.value_or(0) & 0xFF);
  }
  if (bits > kMostBits)
    return add(rules::kMappingLong, transfer, scene, fmt::format("{}: {} bits", name_of(record), bits));
  if (!is_known && is_aborted_by(transfer, canopen::AbortCode::PdoLengthExceeded))
    return add(rules::kMappingLong, transfer, scene,
               fmt::format("{}: {} entries", name_of(record), transfer.value));
  const bool is_other = changed_.contains({node.id, record});
  if (transfer.is_done() && transfer.value != 0 && is_other && is_valid(node, record) == false)
    in_work_[{node.id, record}] = transfer.request;
}

}  // namespace audit
