#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "modbus/frame.hpp"
#include "modbus/register_bank.hpp"

namespace modbus {

/// What a server has answered so far.
struct Counters {
  std::uint64_t requests = 0;
  std::uint64_t exceptions = 0;  ///< among the answers
};

/// One client of a server: a stream of bytes in, a stream of bytes out, of whatever sizes. Requests are answered
/// in their order. What waits here is bounded: while the client leaves answers unread, no more of its requests are
/// taken.
class Connection {
 public:
  /// Both outlive this.
  Connection(RegisterBank& bank, Counters& counters) noexcept : bank_{bank}, counters_{counters} {}

  /// Where bytes that have come are to be put; empty while no more are wanted.
  std::span<std::uint8_t> room() noexcept;
  /// So many bytes were put there.
  void on_received(std::size_t bytes) noexcept { held_ += bytes; }
  /// No more will come: what is whole is answered yet.
  void on_end() noexcept { has_ended_ = true; }
  /// Answers up to @p most of the requests that have come, as far as there is room for answers. Bytes that are no
  /// frames end the stream.
  void answer(std::size_t most) noexcept;

  /// Whether a whole request waits for answer().
  bool has_request() const noexcept;
  /// Answers that the client has not got yet.
  std::span<const std::uint8_t> to_send() const noexcept { return std::span{output_}.first(answered_); }
  /// So many bytes of them are on their way.
  void on_sent(std::size_t bytes) noexcept;
  /// Whether nothing will come and nothing is left to be sent.
  bool is_over() const noexcept { return has_ended_ && answered_ == 0 && !has_request(); }

 private:
  /// A request and the beginning of the next ones.
  static constexpr std::size_t kInputBytes = 2 * kMostFrameBytes;
  static constexpr std::size_t kOutputBytes = 4 * kMostFrameBytes;

  bool has_room_for_answer() const noexcept { return kOutputBytes - answered_ >= kMostFrameBytes; }
  void answer(const Frame& request) noexcept;

  RegisterBank& bank_;
  Counters& counters_;
  std::size_t held_ = 0;      ///< bytes of input
  std::size_t answered_ = 0;  ///< bytes of output
  bool has_ended_ = false;
  std::array<std::uint8_t, kInputBytes> input_{};
  std::array<std::uint8_t, kOutputBytes> output_{};
};

}  // namespace modbus
