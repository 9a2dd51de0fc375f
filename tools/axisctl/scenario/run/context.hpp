#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "tools/axisctl/scenario/run/stations.hpp"

namespace scenario {

/// A fault that a step has loaded.
struct Injected {
  Unit* unit = nullptr;  ///< null: into the bus
  std::uint32_t id = 0;
};

/// What steps work with.
struct Context {
  const Scenario& scenario;
  Bench& bench;
  Stations& stations;
  std::map<std::string, Injected> faults{};  ///< by their names
  std::size_t mark = 0;                      ///< frames from here on are those that an expectation looks at
};

/// What the unit answers to @p method; the error is one line.
[[nodiscard]] inline tl::expected<nlohmann::json, std::string> ask(
    Unit& unit, std::string_view method, nlohmann::json params = nlohmann::json::object()) {
  auto answer = unit.client.ask({method, std::move(params)});
  if (answer) return *std::move(answer);
  return tl::unexpected{answer.error().message};
}

}  // namespace scenario
