#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <linux/sock_diag.h>
#include <sys/socket.h>

#include "can/port/port.hpp"
#include "os/descriptor.hpp"

namespace bus {

/// Sets an option of a socket; false with errno set if the kernel refuses.
template <class Value>
bool set_option(const os::Descriptor& socket, int level, int name, const Value& value) noexcept {
  return ::setsockopt(socket.get(), level, name, &value, sizeof value) == 0;
}

/// Asks for a receive buffer of @p bytes. Only an administrator may pass net.core.rmem_max; receive_buffer_of()
/// tells what came of it.
inline void ask_for_receive_buffer(const os::Descriptor& socket, int bytes) noexcept {
  if (!set_option(socket, SOL_SOCKET, SO_RCVBUFFORCE, bytes)) set_option(socket, SOL_SOCKET, SO_RCVBUF, bytes);
}

/// The receive buffer that @p socket has got where @p wanted bytes were asked for.
inline std::optional<ReceiveBuffer> receive_buffer_of(const os::Descriptor& socket, int wanted) noexcept {
  int size = 0;
  socklen_t length = sizeof size;
  if (::getsockopt(socket.get(), SOL_SOCKET, SO_RCVBUF, &size, &length) != 0) return std::nullopt;
  constexpr std::size_t kOverhead = 2;  // the kernel counts its own as much again
  return ReceiveBuffer{static_cast<std::size_t>(size) / kOverhead, static_cast<std::size_t>(wanted)};
}

/// Messages that @p socket has lost because its receive buffer was full; the kernel counts up to 2^32.
inline std::uint64_t lost_messages(const os::Descriptor& socket) noexcept {
  std::array<std::uint32_t, SK_MEMINFO_VARS> counters{};
  socklen_t size = sizeof counters;
  if (::getsockopt(socket.get(), SOL_SOCKET, SO_MEMINFO, counters.data(), &size) != 0) return 0;
  return counters[SK_MEMINFO_DROPS];
}

}  // namespace bus
