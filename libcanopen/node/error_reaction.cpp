#include "libcanopen/node/error_reaction.hpp"

namespace canopen {

void ErrorReaction::raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept {
  if (services_.errors.raise(code, detail, error_register)) services_.transmit.on_values_changed();
}

void ErrorReaction::clear(std::uint16_t code, std::uint16_t detail) noexcept {
  if (services_.errors.clear(code, detail)) services_.transmit.on_values_changed();
}

void ErrorReaction::on_error(CommunicationError error, std::uint16_t detail) noexcept {
  const CommunicationErrorRow& row = row_of(error);
  raise(row.emcy_code, detail, row.error_register);
  context_.application.on_communication_error(error, detail);
  if (row.changes_nmt_state) apply_behaviour(kCommunicationErrorClass);
}

void ErrorReaction::on_recovery(CommunicationError error, std::uint16_t detail) noexcept {
  clear(row_of(error).emcy_code, detail);
  context_.application.on_communication_recovery(error, detail);
}

void ErrorReaction::apply_behaviour(std::uint8_t error_class) noexcept {
  if (!kStatesOfNmt.contains(context_.state)) return;
  context_.nmt.enter(services_.error_behaviour.after(error_class, context_.state));
}

}  // namespace canopen
