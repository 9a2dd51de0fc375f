#include "tools/canopen-check/core/undo_log.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace conformance {

void UndoLog::keep(std::uint16_t index, std::uint8_t sub_index) {
  SdoAnswer before = sdo_->upload(index, sub_index);
  if (before.done()) steps_.push_back({index, sub_index, std::move(before.data)});
}

SdoAnswer UndoLog::write(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes) {
  keep(index, sub_index);
  return sdo_->download(index, sub_index, bytes);
}

std::vector<std::string> UndoLog::restore() {
  std::map<std::pair<std::uint16_t, std::uint8_t>, std::vector<std::uint8_t>> first;
  for (const Step& step : steps_) first.try_emplace({step.index, step.sub_index}, step.before);
  while (!steps_.empty()) {
    const Step step = std::move(steps_.back());
    steps_.pop_back();
    const SdoAnswer now = sdo_->upload(step.index, step.sub_index);
    if (!now.done() || now.data != step.before) (void)sdo_->download(step.index, step.sub_index, step.before);
  }
  std::vector<std::string> left;
  for (const auto& [entry, before] : first) {
    const SdoAnswer now = sdo_->upload(entry.first, entry.second);
    if (now.done() && now.data == before) continue;
    left.push_back(fmt::format("{:04X}h:{:02X} holds {}, held {} before", entry.first, entry.second, to_text(now),
                               hexadecimal(before)));
  }
  return left;
}

}  // namespace conformance
