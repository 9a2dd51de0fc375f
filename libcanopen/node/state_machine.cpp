#include "libcanopen/node/state_machine.hpp"

#include "libcanopen/base/object_index.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kFirstApplicationObject = 0x2000;
constexpr std::uint16_t kLastApplicationObject = 0x9FFF;

}  // namespace

void StateMachine::start() noexcept {
  if (context_.pending_node_id != context_.dictionary.node_id()) return reset(NmtCommand::ResetCommunication);
  const bool runs_on = context_.state == NmtState::Operational && policy_.start_state == NmtState::Operational;
  if (runs_on) enter(NmtState::PreOperational);  // or nothing would begin anew
  boot();
}

void StateMachine::reload() noexcept {
  if (context_.state == NmtState::Initialising) return;
  services_.reload(Reload::TakeOver);
  services_.reload_after_boot_up(Reload::TakeOver);
  services_.go_on();
}

void StateMachine::reset(NmtCommand command) noexcept {
  enter(NmtState::Initialising);
  context_.dictionary.set_node_id(context_.pending_node_id);
  context_.dictionary.restore(object::kFirstOfCommunication, object::kLastOfCommunication);
  if (command == NmtCommand::ResetNode) {
    context_.dictionary.restore(kFirstApplicationObject, kLastApplicationObject);
  }
  context_.application.on_reset(command);
  boot();
}

void StateMachine::boot() noexcept {
  const std::uint8_t node_id = context_.dictionary.node_id();
  const bool is_configured = node_id != kNoNodeId;
  services_.reload(Reload::Afresh);
  if (is_configured)
    context_.sink->send(frame_under(function_code::kErrorControl + node_id, 1), Delivery::Ordered);
  services_.reload_after_boot_up(Reload::Afresh);
  enter(is_configured ? policy_.start_state : NmtState::Unconfigured);
}

void StateMachine::enter(NmtState state) noexcept {
  const NmtState from = context_.state;
  if (state == from) return;
  context_.state = state;
  services_.leave();
  context_.application.on_nmt_state(from, state);
  services_.enter();  // of the state that the application has perhaps gone on to
}

}  // namespace canopen
