#include "audit/sdo/dialogues.hpp"

#include "libcanopen/base/nmt_state.hpp"

namespace audit {

namespace {

bool is_reset(const canopen::Frame& frame) noexcept {
  const auto command = static_cast<canopen::NmtCommand>(frame.data[0]);
  return frame.length == 2 &&
         (command == canopen::NmtCommand::ResetNode || command == canopen::NmtCommand::ResetCommunication);
}

}  // namespace

std::optional<Transfer> Dialogues::take(const Passage& passage, Findings& findings) {
  if (passage.heard.is_error) return std::nullopt;
  if (passage.meaning.role == meaning::Role::Nmt && is_reset(passage.frame())) reset(passage.heard, findings);
  const bool has_booted = passage.meaning.role == meaning::Role::ErrorControl && passage.frame().length == 1 &&
                          passage.frame().data[0] == 0;
  if (has_booted) forget(passage.meaning.node);
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
