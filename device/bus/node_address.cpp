#include "device/bus/node_address.hpp"

#include "drive/images/storage_image.hpp"

namespace device {

std::uint8_t address_without_switch(const Configuration& configuration, std::span<const std::byte> saved) {
  constexpr std::uint16_t kAddress = 8620;
  drive::DriveUnit unit{unit_configuration(configuration).drive};
  drive::DriveObject& control_unit = *unit.object(drive::kControlUnitNumber);
  static_cast<void>(drive::storage_image::load(unit, saved));
  for (const unit::ParameterPreset& preset : configuration.presets)
    if (preset.number == kAddress) static_cast<void>(control_unit.load(kAddress, preset.index, preset.value));
  return static_cast<std::uint8_t>(control_unit.read(kAddress).value_or(0.0));
}

}  // namespace device
