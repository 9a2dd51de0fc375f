#include "daemon/instance/modbus_door.hpp"

namespace axisd {

ModbusDoor::ModbusDoor(const ModbusSettings& settings, device::Device& device, profidrive::Interface& if1)
    : device_{device},
      face_{device.runner()},
      registers_{device.runner(), if1, face_},
      server_{settings, registers_} {
  if1.serve_modbus();
  device.attach(face_);
}

void ModbusDoor::handle(canopen::TimePoint now) noexcept {
  device_.begin_access(now);
  server_.handle();
}

}  // namespace axisd
