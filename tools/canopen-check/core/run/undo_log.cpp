#include "tools/canopen-check/core/run/undo_log.hpp"

#include <fmt/format.h>

namespace conformance {

SdoAnswer UndoLog::keep(std::uint16_t index, std::uint8_t sub_index) {
  SdoAnswer before = sdo_->upload(index, sub_index);
  if (before.done()) steps_.push_back({{index, sub_index}, before.data});
  return before;
}

SdoAnswer UndoLog::write(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes) {
  (void)keep(index, sub_index);
  return sdo_->download(index, sub_index, bytes);
}

std::vector<std::string> UndoLog::restore() {
  EntryValues first;
  for (const Step& step : steps_) first.try_emplace(step.entry, step.before);
  // Where anything has to go back, all of it goes: on that way an entry may lose the value that it holds now.
  if (not_seen_in(*sdo_, first).empty()) steps_.clear();
  if (steps_.empty()) return {};
  bool silent = false;  // a node that has gone is not asked again
  for (; !steps_.empty() && !silent; steps_.pop_back()) {
    const auto& [entry, before] = steps_.back();
    SdoAnswer answer = sdo_->upload(entry.first, entry.second);
    if (!answer.done() || answer.data != before) answer = sdo_->download(entry.first, entry.second, before);
    silent = silent || answer.kind == SdoAnswer::Kind::Silent;
  }
  steps_.clear();
  std::vector<std::string> left;
  for (const auto& [entry, before] : not_seen_in(*sdo_, first)) {
    const SdoAnswer now = silent ? SdoAnswer{} : sdo_->upload(entry.first, entry.second);
    if (now.done() && now.data == before) continue;
    left.push_back(fmt::format("{:04X}h:{:02X} holds {}, held {} before", entry.first, entry.second, to_text(now),
                               hexadecimal(before)));
  }
  return left;
}

}  // namespace conformance
