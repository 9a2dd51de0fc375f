#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nats {

/// Where a stream has put a message, and how a consumer has told it.
struct Delivery {
  std::uint64_t sequence = 0;           ///< of the message in its stream
  std::uint64_t consumer_sequence = 0;  ///< counts what the consumer has told, from 1
  std::int64_t time_ns = 0;             ///< when the stream took it in, since 1 January 1970
  std::uint64_t pending = 0;            ///< messages that the consumer is to tell still
};

/// Reads the reply subject of a message that a consumer has told; nothing if @p reply is not of one.
[[nodiscard]] std::optional<Delivery> parse_delivery(std::string_view reply) noexcept;

}  // namespace nats
