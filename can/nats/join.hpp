#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "can/nats/bus.hpp"

namespace nats {

/// A connection to the stream of one bus, whose socket is served by whoever polls it.
struct Membership {
  Connection connection;
  Subscription subscription;  ///< before which the connection must not end
  int socket = -1;
  bool wants_to_write = false;  ///< there is more than the socket took

  Membership() = default;
  Membership(const Membership&) = delete;
  Membership& operator=(const Membership&) = delete;
  /// Closes.
  ~Membership();
};

/// Makes the stream of @p bus if there is none, and joins it: what the stream takes in from now on comes to the
/// subscription. Waits up to @p patience for each answer. The error is one line.
[[nodiscard]] tl::expected<std::unique_ptr<Membership>, std::string> join(const Bus& bus,
                                                                          std::chrono::milliseconds patience);

}  // namespace nats
