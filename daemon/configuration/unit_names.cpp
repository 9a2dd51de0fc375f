#include <string>

#include <fmt/format.h>

#include "daemon/configuration/configuration.hpp"

namespace axisd {
namespace {

constexpr std::uint32_t kFirstSerial = Cia402Settings{}.serial;

}  // namespace

std::string station_of(const Configuration& unit) {
  if (unit.node_id != Cia402Settings::kUnconfigured) return std::to_string(unit.node_id);
  const std::uint32_t serial = unit.cia402 ? unit.cia402->serial : kFirstSerial;
  return serial == kFirstSerial ? "unconfigured" : fmt::format("unconfigured-{}", serial);
}

std::string bus_of(const Configuration& unit) {
  return unit.bus.empty() ? bus::label(unit.address) : unit.bus;
}

std::string name_of(const Configuration& unit) {
  return fmt::format("{}/{}", bus_of(unit), station_of(unit));
}

std::string folder_of(const Configuration& unit) {
  return fmt::format("{}-{}", bus_of(unit), station_of(unit));
}

}  // namespace axisd
