#include "drive/infeed/infeed.hpp"

#include <utility>

#include "drive/base/elapsed.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kMonitoringTime = 857;
constexpr std::uint16_t kNotReady = 7802;
constexpr std::uint16_t kUndervoltage = 30003;

/// Bits 0 to 3 of a controlword.
std::uint16_t command_word(const InfeedInputs& inputs, bool enable) noexcept {
  constexpr unsigned kOn = 0x1, kNoOff2 = 0x2, kNoOff3 = 0x4, kEnable = 0x8;
  return static_cast<std::uint16_t>((inputs.on ? kOn : 0U) | (inputs.has_off2() ? 0U : kNoOff2) | kNoOff3 |
                                    (enable ? kEnable : 0U));
}

}  // namespace

Infeed::Infeed(const ObjectContext& context) : DriveObject{context} {
  restore_parameters();
}

void Infeed::cycle(double duration, const Link& link) noexcept {
  link_ = link;
  const State state_before = state_;
  const bool same = inputs_before_ == inputs_ && external_before_ == external_messages_.inputs;
  inputs_before_ = inputs_;
  external_before_ = external_messages_.inputs;
  settled_ = true;
  if (external_messages_.acknowledges()) acknowledge();
  apply(Event::Initialised);
  // What has just become Switch on disabled is seen so for a cycle, whatever else is given.
  if (state_ == state_before) {
    const bool enable = inputs_.enable_operation && (has_link() || operates());
    apply(command_of(inhibited_ ? std::uint16_t{0} : command_word(inputs_, enable)));
    apply(Event::Standstill);  // nothing turns: an OFF1 is over with its beginning
    await_link(duration);
    const bool operated = state_before == State::OperationEnabled && operates();
    if (operated && link_.lowest < context().supply.undervoltage) static_cast<void>(raise(kUndervoltage));
  }
  settled_ = settled_ && state_ == state_before && same;
}

/// F07802, once, when the DC link has not come within p0857 after ON.
void Infeed::await_link(double duration) noexcept {
  const bool waits = state_ == State::SwitchedOn && !has_link();
  const double before = std::exchange(link_missing_, waits ? link_missing_ + duration : 0.0);
  const double limit = read(kMonitoringTime).value_or(0.0) * row_of(Unit::Milliseconds).si;
  if (!elapsed(before, limit) && elapsed(link_missing_, limit)) static_cast<void>(raise(kNotReady));
}

void Infeed::apply(Event event) noexcept {
  if (const Transition* const row = find_transition(state_, event)) state_ = row->to;
}

/// Whatever a fault does to a motor, the infeed is switched off by it.
void Infeed::react(const FaultRow& row) noexcept {
  if (messages().settings.reaction_to(row).value_or(row.reaction) != Reaction::None) apply(Event::FaultOff2);
}

bool Infeed::acknowledge() noexcept {
  const bool none_left = memory().acknowledge(operates());
  if (none_left) apply(Event::Acknowledged);
  on_messages_changed();
  return none_left;
}

void Infeed::on_acknowledged_fault_left() noexcept {
  if (messages().faults().empty()) apply(Event::Acknowledged);
}

void Infeed::power_off() noexcept {
  DriveObject::power_off();
  state_ = State::SwitchOnDisabled;
  inputs_ = inputs_before_ = {};
  external_messages_.power_off();
  external_before_ = {};
  settled_ = false;
}

void Infeed::inhibit(bool inhibited) noexcept {
  inhibited_ = inhibited;
  settled_ = false;
}

void* Infeed::own_block(BlockId id) noexcept {
  return find_block(id, *this, inputs_, external_messages_);
}

const void* Infeed::own_block(BlockId id) const noexcept {
  return find_block(id, *this, inputs_, external_messages_);
}

WriteState Infeed::write_state() const noexcept {
  return {.pulses_enabled = operates()};
}

}  // namespace drive
