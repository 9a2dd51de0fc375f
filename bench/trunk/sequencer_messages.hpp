#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include "bench/trunk/byte_queue.hpp"

/// What the sequencer and its clients tell each other over TCP: a head in the byte order of the machine, and the
/// bytes of a message behind.
namespace bench {

/// To the sequencer.
struct AskedHead {
  std::uint32_t size = 0;  ///< of the message (bytes)
};

/// From the sequencer.
struct GivenHead {
  std::uint32_t size = 0;  ///< of the message (bytes)
  std::uint32_t unused = 0;
  std::uint64_t sequence = 0;  ///< of all messages, from 1 on; 0: greets who has connected
  std::int64_t time_ns = 0;    ///< when it was taken in, CLOCK_REALTIME
};

/// Bytes that are read at once.
inline constexpr std::size_t kReadAtOnce = 1U << 16U;

/// A message that is whole in a queue, at the beginning of that.
template <class Head>
struct Whole {
  Head head;
  std::span<const std::byte> bytes;

  /// Bytes of both.
  [[nodiscard]] std::size_t size() const noexcept { return sizeof head + bytes.size(); }
};

/// The first message of @p queue, if all of it is there.
template <class Head>
std::optional<Whole<Head>> first_of(const ByteQueue& queue) noexcept {
  const std::span<const std::byte> waiting = queue.waiting();
  Whole<Head> whole;
  if (waiting.size() < sizeof whole.head) return std::nullopt;
  std::memcpy(&whole.head, waiting.data(), sizeof whole.head);
  if (waiting.size() - sizeof whole.head < whole.head.size) return std::nullopt;
  whole.bytes = waiting.subspan(sizeof whole.head, whole.head.size);
  return whole;
}

/// Puts @p bytes with @p head, whose size comes of them, into @p queue.
template <class Head>
void put_message(ByteQueue& queue, Head head, std::span<const std::byte> bytes) {
  head.size = static_cast<std::uint32_t>(bytes.size());
  queue.put(std::as_bytes(std::span{&head, 1}));
  queue.put(bytes);
}

}  // namespace bench
