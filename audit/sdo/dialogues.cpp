#include "audit/sdo/dialogues.hpp"

namespace audit {

std::optional<Transfer> Dialogues::take(const Passage& passage, Findings& findings) {
  if (passage.heard.is_error) return std::nullopt;
  if (passage.is_reset()) reset(passage.heard, findings);
  if (passage.is_boot_up()) forget(passage.meaning.node);
  if (passage.meaning.role == meaning::Role::SdoRequest)
    return dialogue(passage.meaning).take_request(passage.heard, findings);
  if (passage.meaning.role == meaning::Role::SdoResponse)
    return dialogue(passage.meaning).take_response(passage.heard, findings);
  return std::nullopt;
}

void Dialogues::end(canopen::Duration at, Findings& findings) {
  for (auto& [channel, dialogue] : dialogues_) dialogue.end(at, findings);
}

void Dialogues::reset(const Heard& heard, Findings& findings) {
  const std::uint8_t node = heard.frame.data[1];
  for (auto& [channel, dialogue] : dialogues_)
    if (node == 0 || node == channel.node) dialogue.reset(heard, findings);
}

void Dialogues::forget(std::uint8_t node) {
  for (auto& [channel, dialogue] : dialogues_)
    if (node == channel.node) dialogue.take_boot_up();
}

Dialogue& Dialogues::dialogue(const meaning::Meaning& meaning) {
  const meaning::SdoChannel channel{meaning.node, meaning.number};
  return dialogues_.try_emplace(channel, channel, has_times_).first->second;
}

}  // namespace audit
