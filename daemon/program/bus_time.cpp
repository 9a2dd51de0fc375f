#include "daemon/program/bus_time.hpp"

#include <algorithm>
#include <variant>

/// Tells the library that with-can preloads to leave the clocks of this program alone.
extern "C" [[gnu::used, gnu::visibility("default")]] const int can_bus_native_time = 1;

namespace axisd {

std::unique_ptr<bus::TimeShare> join_bus_time(std::span<const Configuration> units) {
  const auto is_user_bus = [](const Configuration& unit) {
    return std::holds_alternative<bus::UserBusPath>(unit.address.place);
  };
  const auto unit = std::ranges::find_if(units, is_user_bus);
  if (unit == units.end()) return nullptr;
  auto time = bus::TimeShare::join(unit->address, userbus::kDevice);
  if (time) os::use_time(*time);
  return time;
}

}  // namespace axisd
