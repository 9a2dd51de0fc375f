#include "daemon/control/parameters/parameter_write.hpp"

#include "daemon/control/parameters/parameter_value.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {

Taken<void> write_and_tell(const Call& call, const ParameterTarget& target, double value) {
  device::Device& device = call.instance.device();
  if (!device.is_on()) return tl::unexpected{unit_is_off()};
  const bool is_saving = device.is_saving();
  const std::uint8_t object = target.object->number();
  const std::uint16_t number = target.row().number;
  const auto written = device.write_parameter(object, number, target.index, value, call.now);
  if (!written) return tl::unexpected{refusal_of(written.error(), target, is_saving)};
  return {};
}

}  // namespace axisd
