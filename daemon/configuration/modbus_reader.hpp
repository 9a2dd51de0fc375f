#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/configuration/settings/modbus_settings.hpp"

namespace axisd {

/// true, or where Modbus TCP is served as the object @p json says; false is nowhere. Throws ConfigurationError.
std::optional<ModbusSettings> read_modbus(const JsonReader& json);

/// The places that the units of a program have taken.
class ModbusPlaces {
 public:
  /// Entry @p entry of /units, which is @p json, takes @p wanted. Throws ConfigurationError if another unit has
  /// it.
  void take(const JsonReader& json, std::size_t entry, const ModbusSettings& wanted);

 private:
  struct Taken {
    ModbusSettings settings{};
    std::size_t entry = 0;
  };
  std::vector<Taken> taken_;
};

}  // namespace axisd
