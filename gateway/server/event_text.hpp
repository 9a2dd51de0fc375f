#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace gateway {

/// A part of a stream of server-sent events, shared by all viewers that get it.
using EventText = std::shared_ptr<const std::string>;

/// An event (HTML Living Standard, 9.2): @p data in one line, called @p name, with @p id unless that is 0.
[[nodiscard]] EventText event_text(std::string_view name, std::string_view data, std::uint64_t id = 0);

/// What a stream begins with: how long a client waits before it comes back (ms).
[[nodiscard]] EventText stream_start();

/// A comment, by which both ends see that the connection lives.
[[nodiscard]] EventText heartbeat();

}  // namespace gateway
