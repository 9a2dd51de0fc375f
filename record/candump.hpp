#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "libcanopen/base/frame.hpp"

namespace record {

/// @p frame as a line of `candump -l`, which canplayer and others read: "(1700000000.123456) can0 605#40...".
/// @p wall_clock is since 1970.
std::string candump_line(const canopen::Frame& frame, std::chrono::nanoseconds wall_clock,
                         std::string_view interface);

}  // namespace record
