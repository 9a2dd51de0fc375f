#include "audit/objects/object_topic.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "audit/base/transfer.hpp"
#include "audit/network/network.hpp"
#include "audit/network/pdo_record.hpp"
#include "audit/objects/object_rules.hpp"
#include "libcanopen/od/abort_code.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace rules = object_rules;

using canopen::AbortCode;

namespace {

/// What an abort code of a server says of its client.
struct CodeRow {
  AbortCode code;
  const Rule* rule;
};
constexpr std::array kCodes{
    CodeRow{AbortCode::ReadOnly, &rules::kReadOnly},     CodeRow{AbortCode::WriteOnly, &rules::kWriteOnly},
    CodeRow{AbortCode::NoObject, &rules::kMissing},      CodeRow{AbortCode::NoSubIndex, &rules::kMissing},
    CodeRow{AbortCode::LengthMismatch, &rules::kLength}, CodeRow{AbortCode::LengthTooHigh, &rules::kLength},
    CodeRow{AbortCode::LengthTooLow, &rules::kLength},   CodeRow{AbortCode::InvalidValue, &rules::kLimits},
    CodeRow{AbortCode::ValueTooHigh, &rules::kLimits},   CodeRow{AbortCode::ValueTooLow, &rules::kLimits},
    CodeRow{AbortCode::LocalControl, &rules::kState},    CodeRow{AbortCode::DeviceState, &rules::kState},
};

/// The rule that @p transfer has broken, as the EDS has @p entry.
const Rule* rule_by_eds(const Transfer& transfer, const eds::EntryFacts& entry, std::uint8_t node) {
  if (!transfer.is_write) return nullptr;
  if (!entry.numeric()) return nullptr;
  const bool is_of_length =
      transfer.is_size_told ? transfer.bytes == entry.bytes() : transfer.bytes >= entry.bytes();
  if (!is_of_length) return &rules::kLength;
  std::array<std::uint8_t, sizeof transfer.value> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(transfer.value >> 8 * i);
  const auto number = eds::decode(std::span{bytes}.first(entry.bytes()), *entry.type).at(node);
  const auto low = entry.low ? entry.low->at(node) : std::nullopt;
  const auto high = entry.high ? entry.high->at(node) : std::nullopt;
  const bool is_beyond = number && ((low && *number < *low) || (high && *number > *high));
  return is_beyond ? &rules::kLimits : nullptr;
}

}  // namespace

void ObjectTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  if (!transfer.is_done())
    scene.time_lines[node.id].add(transfer.last,
                                  fmt::format("{} aborted: {}", meaning::name_of(transfer.at, node.description),
                                              meaning::abort_text(transfer.abort_code)));
  if (transfer.is_malformed) return;
  const Rule* rule = nullptr;
  if (transfer.end == Transfer::End::AbortedByServer) {
    const auto* const row = std::ranges::find(kCodes, AbortCode{transfer.abort_code}, &CodeRow::code);
    if (row != kCodes.end()) rule = row->rule;
  } else if (transfer.is_done()) {
    const eds::EntryFacts* const entry = node.description.find(transfer.at.index, transfer.at.sub_index);
    if (entry != nullptr) rule = rule_by_eds(transfer, *entry, node.id);
  }
  const bool is_of_pdo = pdo_at(transfer.at.index).has_value();  // why they are refused is up to PdoSettingTopic
  const bool is_explained = !transfer.is_done() && scene.findings.total() != scene.found_before;
  if (rule == nullptr || is_explained || (is_of_pdo && (rule == &rules::kLimits || rule == &rules::kState)))
    return;
  scene.findings.add(*rule, node.id, {transfer.request, transfer.last}, [&] {
    std::string text = meaning::name_of(transfer.at, node.description);
    if (transfer.is_write && transfer.bytes <= sizeof transfer.value)
      text += fmt::format(" = {:0{}X}h ({} bytes)", transfer.value, 2 * transfer.bytes, transfer.bytes);
    return transfer.is_done() ? text + ", which the device has taken"
                              : text + ", abort " + meaning::abort_text(transfer.abort_code);
  });
}

}  // namespace audit
