#include "drive/control_unit.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kCommissioningFilter = 9;

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

double ControlUnit::own_value(const ParameterRow& row, std::size_t index) const noexcept {
  const auto* const display = std::get_if<Computed<ControlUnit>>(&row.home);
  return display != nullptr ? display->get(*this, index) : 0.0;
}

void ControlUnit::set_own_value(const ParameterRow& row, std::size_t index, double value) noexcept {
  const auto* const computed = std::get_if<Computed<ControlUnit>>(&row.home);
  if (computed != nullptr && computed->set != nullptr) computed->set(*this, index, value);
}

WriteState ControlUnit::write_state() const noexcept {
  return {.pulses_enabled = false, .filter = static_cast<int>(read(kCommissioningFilter).value_or(0.0))};
}

}  // namespace drive
