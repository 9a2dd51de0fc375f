#include "libcanopen/nmt/nmt_slave.hpp"

#include <algorithm>
#include <array>

#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {

/// Which state a command leads to; the reset commands are handled before.
struct CommandRow {
  NmtCommand command;
  NmtState state;
};
constexpr std::array kStateCommands{
    CommandRow{NmtCommand::Start, NmtState::Operational},
    CommandRow{NmtCommand::Stop, NmtState::Stopped},
    CommandRow{NmtCommand::EnterPreOperational, NmtState::PreOperational},
};

}  // namespace

NmtSlave::NmtSlave(Context& context) : Service{context, {.lives_in = kStatesOfNmt, .identifiers = 1}} {}

void NmtSlave::list_identifiers(IdentifierList& list) const noexcept {
  list.hears_nmt();
}

void NmtSlave::on_frame(const Frame& frame, std::size_t) noexcept {
  const std::uint8_t to = frame.data[1];
  if (frame.length != 2 || (to != 0 && to != context_.dictionary.node_id())) return;
  command(static_cast<NmtCommand>(frame.data[0]));
}

void NmtSlave::command(NmtCommand command) noexcept {
  if (command == NmtCommand::ResetNode || command == NmtCommand::ResetCommunication)
    return context_.nmt.reset(command);
  if (!kStatesOfNmt.contains(context_.state)) return;
  const auto row = std::find_if(kStateCommands.begin(), kStateCommands.end(),
                                [=](const CommandRow& r) { return r.command == command; });
  if (row != kStateCommands.end()) {
    context_.nmt.enter(row->state);
  } else if (context_.policy.unknown_command == UnknownCommand::Stop) {
    context_.nmt.enter(NmtState::Stopped);
  }
}

}  // namespace canopen
