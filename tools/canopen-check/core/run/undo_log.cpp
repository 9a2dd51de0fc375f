#include "tools/canopen-check/core/run/undo_log.hpp"

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
  bool silent = false;  // a node that has gone is not asked again
  for (; !steps_.empty() && !silent; steps_.pop_back()) {
    const Step& step = steps_.back();
    SdoAnswer answer = sdo_->upload(step.index, step.sub_index);
    if (!answer.done() || answer.data != step.before)
      answer = sdo_->download(step.index, step.sub_index, step.before);
    silent = silent || answer.kind == SdoAnswer::Kind::Silent;
  }
  steps_.clear();
  std::vector<std::string> left;
  for (const auto& [entry, before] : first) {
    const SdoAnswer now = silent ? SdoAnswer{} : sdo_->upload(entry.first, entry.second);
    if (now.done() && now.data == before) continue;
    left.push_back(fmt::format("{:04X}h:{:02X} holds {}, held {} before", entry.first, entry.second, to_text(now),
                               hexadecimal(before)));
  }
  return left;
}

}  // namespace conformance
