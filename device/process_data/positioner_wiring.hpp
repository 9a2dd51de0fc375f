#pragma once

#include <cstdint>

#include "drive/base/positioner_wiring.hpp"
#include "unit/configuration.hpp"

namespace device {

using drive::PositionerWiring;

/// The axis that is to be wired.
struct WiredAxis {
  std::uint8_t module = 0;   ///< its place in the unit, 0..7
  std::uint8_t node_id = 0;  ///< CANopen address in force, 1..127
  drive::ObjectKind kind = drive::ObjectKind::Servo;
  bool setpoint_channel = true;  ///< it is delivered with the extended setpoint channel
};

/// The values that make @p wiring, to PDOs with free objects, on @p axis, whatever was mapped and connected
/// before: mappings of all PDOs, which are its identity, with the COB-IDs of the predefined connection set where
/// that has some (those of further axes stay), the inputs of the controlword, of the words that come and of those
/// that are sent. An input that another wiring connects, and this one does not, has its factory value.
unit::Delivery delivery_of(PositionerWiring wiring, const WiredAxis& axis);

}  // namespace device
