#include "daemon/configuration/modbus_reader.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "can/port/address.hpp"

namespace axisd {
namespace {

bool is_every_address(const ModbusSettings& settings) {
  return settings.address == "0.0.0.0" || settings.address == "::";
}

bool clash(const ModbusSettings& one, const ModbusSettings& other) {
  if (one.port == 0 || one.port != other.port) return false;
  return one.address == other.address || is_every_address(one) || is_every_address(other);
}

}  // namespace

std::optional<ModbusSettings> read_modbus(const JsonReader& json) {
  if (!json.is_object()) return json.boolean() ? std::optional{ModbusSettings{}} : std::nullopt;
  json.expect_object({"address", "port"});
  ModbusSettings settings;
  if (json.has("address")) {
    const auto address = bus::normal_ip_address(json.at("address").text());
    if (!address) json.at("address").fail("an IPv4 or IPv6 address");
    settings.address = *address;
  }
  if (json.has("port"))
    settings.port =
        static_cast<std::uint16_t>(json.at("port").integer(0, std::numeric_limits<std::uint16_t>::max()));
  return settings;
}

void ModbusPlaces::take(const JsonReader& json, std::size_t entry, const ModbusSettings& wanted) {
  const auto known =
      std::ranges::find_if(taken_, [&](const Taken& taken) { return clash(taken.settings, wanted); });
  if (known == taken_.end()) {
    taken_.push_back({wanted, entry});
    return;
  }
  if (known->entry == entry)
    json.at("modbus").fail("a port for each of the units that node_id stands for (0: one that is free)");
  json.at("modbus").fail(fmt::format("a port that /units/{} does not have at this address", known->entry));
}

}  // namespace axisd
