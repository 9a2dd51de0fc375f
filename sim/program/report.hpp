#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "sim/plan/world_plan.hpp"
#include "sim/unit/judge.hpp"
#include "sim/world/world.hpp"

namespace sim {

/// What came of one world.
struct Outcome {
  std::optional<Breach> breach;
  std::uint8_t node_id = 0;  ///< of the unit of the breach
  World::Counts counts;
  std::uint64_t digest = 0;
  double seconds = 0.0;
  std::string last_frames;  ///< before the breach, as candump prints them
};

/// Runs the world of @p plan; what units log goes to @p log, and all frames to @p frames, unless that is nullptr.
/// Throws axisd::ConfigurationError.
Outcome run_world(const WorldPlan& plan, const axisd::Log& log, std::ostream* frames = nullptr);

/// The invariants and the kinds of faults, a line each.
std::string list_text();
/// What is broken in the world of @p plan, with the frames before it, and the options @p again that have it again.
std::string breach_text(const WorldPlan& plan, const Outcome& outcome, std::string_view again);

/// Of many worlds.
struct Sums {
  std::uint64_t worlds = 0;
  std::uint64_t broken = 0;
  std::uint64_t units = 0, faults = 0, frames = 0, turns = 0, power_ons = 0, disk_operations = 0;
  double seconds = 0.0;
  double full_bus_seconds = 0.0;

  void add(const WorldPlan& plan, const Outcome& outcome) noexcept;
};
std::string text_of(const Sums& sums);
nlohmann::json json_of(const Sums& sums);

}  // namespace sim
