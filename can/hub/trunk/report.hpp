#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "can/userbus/protocol.hpp"

namespace hub::trunk {

class Trunk;

/// What has become of frames, since the hub began.
struct Figures {
  std::uint64_t sent = 0;      ///< of this hub's members that have passed
  std::uint64_t received = 0;  ///< of other hubs that have passed here
  /// Of this hub's members that were under way when the wire was cut: none of them has passed here, and nobody
  /// knows which of them have elsewhere.
  std::uint64_t dropped = 0;
  std::uint64_t stale = 0;      ///< of other hubs that came too late, or of an arbiter that is it no more
  std::uint64_t returned = 0;   ///< of other hubs that had been here before, over a bridge
  std::uint64_t repeated = 0;   ///< of this hub's members that somebody has sent a second time
  std::uint64_t malformed = 0;  ///< messages that were none
  std::uint64_t cuts = 0;       ///< times that the wire was cut
};

/// What has become of the frames of @p trunk, and who else is on the bus: JSON, at most @p room bytes. @p lost:
/// frames that were sent while the wire was cut.
[[nodiscard]] std::string report_of(const Trunk& trunk, std::uint64_t lost, std::size_t room);
/// "at 125000 bit/s", "without a bit rate".
[[nodiscard]] std::string text_of_bit_rate(std::uint32_t bit_rate);
/// The row of @p trunk among the members of its hub.
[[nodiscard]] userbus::MemberStatistics row_of(const Trunk& trunk) noexcept;

}  // namespace hub::trunk
