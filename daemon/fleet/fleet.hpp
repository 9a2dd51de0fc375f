#pragma once

#include <filesystem>
#include <list>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include "control/error.hpp"
#include "daemon/fleet/served_unit.hpp"

namespace axisd {

/// What a fleet is made of.
struct FleetPlan {
  std::span<const Configuration> configurations;  ///< of its units; they outlive it
  std::size_t threads;                            ///< loops that run them, at least one
  const std::filesystem::path& state_root;        ///< below which their states are
};

/// All units of the program, and the threads that run them. Its functions belong to the thread that has made it.
class Fleet {
 public:
  /// Lines of the log bear the name of their unit where there are several. Throws InstanceError, bus::OpenError or
  /// std::system_error.
  Fleet(const FleetPlan& plan, const Log& log, InstanceListener& listener, bus::TimeShare* time = nullptr);

  /// Power-on of all units. Throws std::system_error.
  void start();
  /// Power-off of all units.
  void stop() noexcept;

  std::list<ServedUnit>& units() noexcept { return units_; }
  std::list<UnitLoop>& loops() noexcept { return loops_; }
  /// The unit that is meant by @p name: its name, "BUS/NODE", or its node-ID alone, or nothing where there is one.
  tl::expected<ServedUnit*, control::Error> find(std::string_view name);
  /// The unit of @p configuration, which is one of those of the constructor.
  ServedUnit& unit_of(const Configuration& configuration) noexcept {
    return *places_[static_cast<std::size_t>(&configuration - configurations_.data())];
  }

 private:
  std::span<const Configuration> configurations_;
  std::list<UnitLoop> loops_;
  std::list<ServedUnit> units_;
  std::vector<ServedUnit*> places_;                          ///< in the order of the configurations
  std::unordered_map<std::string_view, ServedUnit*> names_;  ///< by the whole name
};

}  // namespace axisd
