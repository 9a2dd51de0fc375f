#include "tools/canopen-check/core/run/undo_log.hpp"

#include <algorithm>

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

UndoLog::Values UndoLog::others(const Values& wanted) {
  constexpr std::size_t kExpedited = 4;
  std::vector<Multiplexor> asked;
  for (const auto& [entry, value] : wanted)
    if (value.size() <= kExpedited) asked.push_back({entry.first, entry.second});
  Values left = wanted;
  const auto frames = sdo_->ask_together(asked);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto now = frames[i] ? whole_answer(*frames[i]) : std::nullopt;
    const auto at = left.find({asked[i].index, asked[i].sub_index});
    if (now && now->done() && now->data == at->second) left.erase(at);
  }
  return left;
}

std::vector<std::string> UndoLog::restore() {
  Values first;
  for (const Step& step : steps_) first.try_emplace(step.entry, step.before);
  const Values changed = others(first);
  // An entry that was changed once, and holds its value, asks for nothing; others come back by the way they went.
  std::map<Entry, unsigned> writes;
  for (const Step& step : steps_) ++writes[step.entry];
  std::erase_if(steps_, [&](const Step& step) {
    return changed.empty() || (!changed.contains(step.entry) && writes[step.entry] == 1);
  });
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
  for (const auto& [entry, before] : others(first)) {
    const SdoAnswer now = silent ? SdoAnswer{} : sdo_->upload(entry.first, entry.second);
    if (now.done() && now.data == before) continue;
    left.push_back(fmt::format("{:04X}h:{:02X} holds {}, held {} before", entry.first, entry.second, to_text(now),
                               hexadecimal(before)));
  }
  return left;
}

}  // namespace conformance
