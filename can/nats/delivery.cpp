#include "can/nats/delivery.hpp"

#include <array>
#include <charconv>
#include <system_error>

namespace nats {

/// "$JS.ACK.STREAM.CONSUMER.DELIVERED.SEQUENCE.CONSUMER_SEQUENCE.TIME.PENDING", of some servers with more tokens
/// in front and one behind.
std::optional<Delivery> parse_delivery(std::string_view reply) noexcept {
  constexpr std::size_t kTokens = 9;
  constexpr std::size_t kInFront = 2;  // of the longer form: domain and account
  std::array<std::string_view, kTokens + kInFront + 1> tokens;
  std::size_t count = 0;
  while (count < tokens.size()) {
    const std::size_t dot = reply.find('.');
    tokens[count++] = reply.substr(0, dot);
    if (dot == std::string_view::npos) break;
    reply.remove_prefix(dot + 1);
  }
  if (count < kTokens || tokens[0] != "$JS" || tokens[1] != "ACK") return std::nullopt;
  enum Place : std::size_t { kSequence = 5, kConsumerSequence, kTime, kPending };
  const std::size_t shift = count == kTokens ? 0 : kInFront;
  const auto is_number = [&](Place place, auto& value) {
    const std::string_view text = tokens[place + shift];
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{};
  };
  Delivery delivery;
  const bool is_whole = is_number(kSequence, delivery.sequence) &&
                        is_number(kConsumerSequence, delivery.consumer_sequence) &&
                        is_number(kTime, delivery.time_ns) && is_number(kPending, delivery.pending);
  return is_whole ? std::optional{delivery} : std::nullopt;
}

}  // namespace nats
