#pragma once

#include <cstdint>
#include <string>

namespace axisd {

/// Where Modbus TCP is served, as key "modbus" says it.
struct ModbusSettings {
  static constexpr std::uint16_t kPort = 502;  ///< assigned to Modbus

  std::string address = "127.0.0.1";  ///< IPv4 or IPv6; 0.0.0.0 or :: is every address of the machine
  std::uint16_t port = kPort;         ///< 0: one that is free

  friend bool operator==(const ModbusSettings&, const ModbusSettings&) = default;
};

}  // namespace axisd
