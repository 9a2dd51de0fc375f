#pragma once

#include <cstdint>
#include <string_view>

#include "cia402/inputs/travel_switches.hpp"

namespace axisd {

/// What the node-ID of a device of profile cia402 may be, for messages.
inline constexpr std::string_view kCia402NodeIds = "an integer 1 to 127, or 255 for a node without node-ID";

/// What a device of profile cia402 is told beside what both profiles have.
struct Cia402Settings {
  /// Key "node_id" of a device without node-ID (CiA 305).
  static constexpr int kUnconfigured = 255;

  std::uint32_t serial = 1;            ///< key "serial": 1018h:4
  std::uint32_t missed_setpoints = 3;  ///< key "missed_setpoints": in a row, which are a fault; 0: never
};

/// The same of one of its axes.
struct Cia402AxisSettings {
  cia402::TravelSwitches switches{};  ///< key "switches", by their roles
  double homing_distance = 200.0;     ///< key "homing_distance" (load revolutions)
};

}  // namespace axisd
