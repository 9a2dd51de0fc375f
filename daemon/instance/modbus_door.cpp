#include "daemon/instance/modbus_door.hpp"

#include <memory>
#include <utility>

namespace axisd {
namespace {

/// @p device has @p face from now on.
template <class Face>
Face& attached(device::Device& device, std::unique_ptr<Face> face) {
  Face& result = *face;
  device.attach(std::move(face));
  return result;
}

}  // namespace

ModbusDoor::ModbusDoor(const ModbusSettings& settings, device::Device& device)
    : device_{device},
      interface_{attached(device, std::make_unique<profidrive::Interface>(device.runner()))},
      face_{attached(device, std::make_unique<modbus::UnitFace>(device.runner(), nullptr))},
      registers_{device.runner(), interface_, face_},
      server_{settings, registers_} {}

void ModbusDoor::handle(canopen::TimePoint now) noexcept {
  device_.begin_access(now);
  server_.handle();
}

}  // namespace axisd
