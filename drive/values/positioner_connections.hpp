#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "drive/parameter/bico.hpp"
#include "drive/parameter/row.hpp"

namespace drive {

/// A BICO input that an axis with the basic positioner is delivered connected to.
struct PositionerConnection {
  std::uint16_t input;
  std::uint8_t index;
  double source;  ///< as the input holds it
};

/// What the inputs of the table hold on a new axis without the module.
inline constexpr double kNoPositionerConnection = 0.0;

/// The factory connections that the function modules position control and basic positioner bring.
inline constexpr std::array kPositionerConnections{
    PositionerConnection{1160, 0, own_source(2562, 0)},   // speed setpoint
    PositionerConnection{1545, 0, own_source(2683, 14)},  // travel to fixed stop
    PositionerConnection{2508, 0, own_source(2684, 0)},   // reference mark is searched
    PositionerConnection{2509, 0, own_source(2684, 1)},   // probe, flying referencing
    PositionerConnection{2512, 0, own_source(2684, 7)},   // correction is to be taken
    PositionerConnection{2513, 0, own_source(2685, 0)},   // correction
    PositionerConnection{2530, 0, own_source(2665, 0)},   // position setpoint
    PositionerConnection{2531, 0, own_source(2666, 0)},   // velocity setpoint
    PositionerConnection{2550, 0, 1.0},                   // enable 2
    PositionerConnection{2551, 0, own_source(2683, 2)},   // setpoint stands
    PositionerConnection{2552, 0, own_source(2683, 14)},  // travel to fixed stop
    PositionerConnection{2553, 0, own_source(2683, 12)},  // fixed stop reached
    PositionerConnection{2554, 0, own_source(2684, 15)},  // traversing command
};

namespace factory {

/// Of an input of that table: its connection on an axis with the positioner.
template <std::uint16_t Input>
double positioner_connection(const ObjectContext& context, std::size_t index) noexcept {
  constexpr const auto* kRow = std::ranges::find(kPositionerConnections, Input, &PositionerConnection::input);
  static_assert(kRow != kPositionerConnections.end(), "an input of the table");
  return context.axis.positioner && index == kRow->index ? kRow->source : kNoPositionerConnection;
}

}  // namespace factory
}  // namespace drive
