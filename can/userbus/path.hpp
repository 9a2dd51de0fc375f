#pragma once

#include "can/userbus/protocol.hpp"

namespace userbus {

/// The path of a bus, with its final zero.
struct Path {
  char text[kLongestPath + 1];
};

/// Writes the folder in which this user's buses are unless he says otherwise: $XDG_RUNTIME_DIR, else /run (root),
/// else /tmp/can-bus-UID, which own_folder() makes. False if it is too long.
bool default_folder(Path& path) noexcept;

/// Writes the default bus to @p path: $CAN_BUS, else can-bus in default_folder(). False if it is longer than
/// kLongestPath; then @p path has as much of it as fits.
bool default_path(Path& path) noexcept;

/// Copies @p text; false if it is longer than kLongestPath or empty.
bool copy_path(const char* text, Path& path) noexcept;

/// Makes the folder /tmp/can-bus-UID (mode 0700) if @p path lies in it: everybody may write to /tmp and take the
/// name. False, with errno, if there is something else, or somebody else has or may change it. Other folders are
/// those of whoever chose them: true.
bool own_folder(const Path& path) noexcept;

}  // namespace userbus
