#pragma once

#include <array>
#include <cstdint>

#include "unit/time.hpp"

namespace trace {

/// Which way a frame goes, as the unit sees it.
enum class Direction : std::uint8_t { Received, Sent };

/// A CAN frame of the unit on the time axis of the trace.
struct Frame {
  unit::TimePoint time{};
  std::uint32_t id = 0;
  bool extended = false;  ///< 29-bit identifier
  bool remote = false;
  Direction direction = Direction::Received;
  std::uint8_t length = 0;
  std::array<std::uint8_t, 8> data{};
};

}  // namespace trace
