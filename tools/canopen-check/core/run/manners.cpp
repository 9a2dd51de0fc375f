#include "tools/canopen-check/core/run/manners.hpp"

#include <fmt/format.h>

#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// What the node says of an error that it has: ", EMCY 5000h pending, 1001h = 01h".
std::string pending_error(Context& context) {
  std::string text;
  if (const auto& frame = context.session().emergency()) {
    const unsigned code = frame->data[0] | unsigned{frame->data[1]} << 8U;
    if (code != 0) text += fmt::format(", EMCY {:04X}h pending", code);
  }
  const SdoAnswer errors = context.read(object::kErrorRegister);
  if (errors.done() && errors.number() != 0) text += fmt::format(", 1001h = {:02X}h", errors.number());
  const SdoAnswer newest = context.read(object::kErrorField, 1);
  if (newest.done() && newest.number() != 0) text += fmt::format(", 1003h:01 = {:08X}h", newest.number());
  return text;
}

}  // namespace

std::string refusal_of_operational(Context& context) {
  constexpr int kAttempts = 3;  // a heartbeat may have been under way before the command
  context.manners().operational_asked = true;
  if (!context.observe_state()) return {};
  context.session().command(canopen::NmtCommand::Start);
  std::optional<canopen::NmtState> state;
  for (int attempt = 0; attempt < kAttempts && !context.session().ended(); ++attempt) {
    state = context.state();
    if (state == canopen::NmtState::Operational) return {};
  }
  if (!state) return {};
  return fmt::format("the slave refuses Operational: it is in {}{}", name_of(*state), pending_error(context));
}

}  // namespace conformance
