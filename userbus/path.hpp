#pragma once

#include "userbus/protocol.hpp"

namespace userbus {

/// The path of a bus, with its final zero.
struct Path {
  char text[kLongestPath + 1];
};

/// Writes the default bus to @p path: $CAN_BUS, else $XDG_RUNTIME_DIR/can-bus, else /tmp/can-bus-UID. False if it
/// is longer than kLongestPath; then @p path has as much of it as fits.
bool default_path(Path& path) noexcept;

/// Copies @p text; false if it is longer than kLongestPath or empty.
bool copy_path(const char* text, Path& path) noexcept;

}  // namespace userbus
