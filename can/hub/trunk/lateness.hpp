#pragma once

#include <chrono>
#include <cstdint>

#include "can/hub/trunk/message.hpp"
#include "libcanopen/base/time.hpp"

namespace hub::trunk {

/// What the stream takes in later than this after its hub had last heard from the stream is let pass by nobody.
inline constexpr canopen::Duration kMostLateness = std::chrono::milliseconds{500};

/// Whether the message of @p header, which the stream has taken in at @p time_ns of its own clock, is so late.
[[nodiscard]] constexpr bool is_late(const Header& header, std::int64_t time_ns) noexcept {
  return header.seen != 0 && time_ns - header.seen > kMostLateness.count();
}

}  // namespace hub::trunk
