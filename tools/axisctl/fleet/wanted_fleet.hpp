#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "farm/documents/settings.hpp"
#include "farm/documents/wanted_unit.hpp"
#include "farm/naming/unit_name.hpp"

namespace fleet {

/// What files of a fleet ask for.
struct WantedFleet {
  std::map<farm::UnitName, farm::WantedUnit> units;
  std::map<std::string, farm::BusSettings> buses;
  std::map<std::string, std::string>
      origins;  ///< where a unit ("line1/5") or a bus is asked for: "FILE: /units/0"
};

/// Adds what @p document, the content of @p file, asks for to @p fleet; a unit or a bus that is there already is
/// refused. The error is one line: "FILE: /units/0: node_id: expected ...". Whether a configuration is one is not
/// looked at.
[[nodiscard]] tl::expected<void, std::string> read_fleet_file(const nlohmann::json& document,
                                                              const std::string& file, WantedFleet& fleet);

/// The units of @p document, which read_fleet_file() has read, as a configuration of axisd with `units` in the
/// same places.
[[nodiscard]] nlohmann::json configuration_of(const nlohmann::json& document);

}  // namespace fleet
