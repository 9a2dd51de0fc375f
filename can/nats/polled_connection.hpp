#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"

namespace nats {

/// A connection whose socket is served by whoever polls it, and never by a thread of the library.
struct PolledConnection {
  Connection connection;
  int socket = -1;
  std::atomic<bool> wants_to_write = false;  ///< there is more than the socket took

  PolledConnection() = default;
  PolledConnection(const PolledConnection&) = delete;
  PolledConnection& operator=(const PolledConnection&) = delete;
  /// Closes.
  ~PolledConnection();

  /// What the socket has not sent will not be sent when it is closed.
  void drop_unsent() const noexcept;
};

/// Connects to @p server, which sees it as @p client; waits up to @p patience for each answer. The error is one
/// line.
[[nodiscard]] tl::expected<std::unique_ptr<PolledConnection>, std::string> connect_polled(
    const Server& server, const std::string& client, std::chrono::milliseconds patience);

}  // namespace nats
