#include "drive/values/unit_values.hpp"

#include <array>
#include <cstdint>

#include "drive/control_unit/control_unit.hpp"

namespace drive::unit_value {

double operating_display(const ControlUnit& unit, std::size_t) noexcept {
  constexpr double kReady = 0.0;
  constexpr double kLeaveCommissioning = 34.0;
  return unit.is_in_commissioning() ? kLeaveCommissioning : kReady;
}

double object_count(const ControlUnit& unit, std::size_t) noexcept {
  const ObjectContext& context = unit.context();
  return context.axis_count + static_cast<double>(first_axis_number(context.has_infeed) - kControlUnitNumber);
}

double module_object(const ControlUnit& unit, std::size_t index) noexcept {
  const ObjectContext& context = unit.context();
  return index < context.axis_count ? static_cast<double>(index + first_axis_number(context.has_infeed)) : 0.0;
}

double mac_address(const ControlUnit&, std::size_t index) noexcept {
  constexpr std::array<std::uint8_t, 6> kLocallyAdministered{0x02, 'A', 'X', 'S', 'I', 'M'};
  return kLocallyAdministered[index];
}

}  // namespace drive::unit_value
