#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "can/nats/bus.hpp"
#include "can/nats/polled_connection.hpp"

namespace nats {

/// A connection to the stream of one bus.
struct Membership {
  std::unique_ptr<PolledConnection> polled;
  Subscription subscription;  ///< ends before the connection
  Subscription requests;      ///< likewise; of an arbiter
};

/// Makes the stream of @p bus if there is none, and joins it: what the stream takes in from now on comes to the
/// subscription. Waits up to @p patience for each answer. The error is one line.
[[nodiscard]] tl::expected<std::unique_ptr<Membership>, std::string> join(const Bus& bus,
                                                                          std::chrono::milliseconds patience);

}  // namespace nats
