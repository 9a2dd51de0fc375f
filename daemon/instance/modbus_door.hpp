#pragma once

#include "daemon/configuration/settings/modbus_settings.hpp"
#include "daemon/modbus/modbus_server.hpp"
#include "device/device.hpp"
#include "modbus/unit_registers.hpp"

namespace axisd {

/// Modbus TCP of a unit: what goes with its cycles, its registers, and the server.
class ModbusDoor {
 public:
  /// Attaches what it needs to @p device, which is not switched on yet; it and @p if1, its process data, outlive
  /// this. Throws InstanceError.
  ModbusDoor(const ModbusSettings& settings, device::Device& device, profidrive::Interface& if1);

  /// What a turn of handle() waits for.
  int descriptor() const noexcept { return server_.descriptor(); }
  /// Something has come at @p now: a bounded share of it is done.
  void handle(canopen::TimePoint now) noexcept;
  const ModbusServer& server() const noexcept { return server_; }

 private:
  device::Device& device_;
  modbus::UnitFace face_;
  modbus::UnitRegisters registers_;
  ModbusServer server_;
};

}  // namespace axisd
