#pragma once

#include <chrono>
#include <string>

#include <tl/expected.hpp>

#include "can/nats/nats_handles.hpp"
#include "can/nats/server.hpp"

namespace nats {

/// A connection to a server and its JetStream, for whoever waits for answers.
struct Session {
  Connection connection;
  JetStream js;  ///< ends before the connection
};

/// Connects to @p server, which sees it under the name @p client; no answer is waited for longer than @p patience.
/// The error is one line.
[[nodiscard]] tl::expected<Session, std::string> open_session(const Server& server, const std::string& client,
                                                              std::chrono::milliseconds patience);

}  // namespace nats
