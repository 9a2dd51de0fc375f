#pragma once

#include <string_view>

#include "bench/trunk/byte_queue.hpp"
#include "os/descriptor.hpp"

namespace bench {

/// A socket that listens at @p place ("ADDRESS:PORT", IPv4) and does not block; throws std::system_error.
os::Descriptor listen_at(std::string_view place);
/// A connection to @p place that sends everything at once and does not block; likewise.
os::Descriptor connect_to(std::string_view place);
/// Has @p socket send everything at once.
void send_at_once(const os::Descriptor& socket);

/// What became of bytes that should come or go.
enum class Transfer : std::uint8_t {
  Done,     ///< some went, or all that there was
  Waiting,  ///< the socket had nothing, or no room
  Failed,   ///< the other end has gone
};
/// Reads once into @p queue.
Transfer read_some(const os::Descriptor& socket, ByteQueue& queue);
/// Writes what waits in @p queue, as far as the socket takes it: Done if nothing waits any more.
Transfer write_all(const os::Descriptor& socket, ByteQueue& queue);

}  // namespace bench
