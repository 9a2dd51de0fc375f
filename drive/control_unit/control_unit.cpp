#include "drive/control_unit/control_unit.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kCommissioningFilter = 9;
constexpr std::uint16_t kToleranceViolated = 1099;

}  // namespace

ControlUnit::ControlUnit(const ObjectContext& context) : DriveObject{context} {
  restore_parameters();
}

bool ControlUnit::is_in_commissioning() const noexcept {
  return write_state().filter != 0;
}

bool ControlUnit::acknowledge() noexcept {
  constexpr bool kPulsesEnabled = false;
  return memory().acknowledge(kPulsesEnabled);
}

void ControlUnit::lead_outputs() noexcept {
  static_assert(Terminals::kOutputs == std::tuple_size_v<decltype(TerminalInputs::outputs)>);
  Terminals::Word word = 0;
  for (std::size_t i = 0; i < terminal_inputs_.outputs.size(); ++i)
    word |= static_cast<Terminals::Word>(terminal_inputs_.outputs[i]) << (Terminals::kFirstOutput + i);
  terminals_.sources = word;
}

void ControlUnit::run_utc(bool runs) noexcept {
  clock_.run_utc(runs);
  withdraw(kToleranceViolated);
}

void ControlUnit::set_clock(UnitClock::Part part, std::uint32_t value) noexcept {
  follow(clock_.give(part, value));
}

void ControlUnit::take_host_time(std::optional<UtcTime> host) noexcept {
  follow(clock_.answer(host));
}

void ControlUnit::follow(UnitClock::Correction correction) noexcept {
  if (correction == UnitClock::Correction::Within) withdraw(kToleranceViolated);
  if (correction == UnitClock::Correction::Beyond)
    static_cast<void>(raise(kToleranceViolated, 0, Cause::Present));  // it is one of the control unit
}

void* ControlUnit::own_block(BlockId id) noexcept {
  return find_block(id, *this, clock_, external_messages_, unit_inputs_, terminal_inputs_);
}

const void* ControlUnit::own_block(BlockId id) const noexcept {
  return find_block(id, *this, clock_, external_messages_, unit_inputs_, terminal_inputs_);
}

WriteState ControlUnit::write_state() const noexcept {
  return {.pulses_enabled = false, .filter = static_cast<int>(read(kCommissioningFilter).value_or(0.0))};
}

}  // namespace drive
