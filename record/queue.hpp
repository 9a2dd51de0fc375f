#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "record/byte_ring.hpp"
#include "record/format.hpp"

namespace record {

/// Records on their way from one thread to another, in memory that is there from the beginning. Neither waits for
/// the other.
class Queue {
 public:
  /// Room for @p bytes.
  explicit Queue(std::size_t bytes) : ring_{bytes} {}

  /// By the one thread: false if there is no room beside @p spare bytes.
  [[nodiscard]] bool push(std::span<const std::byte> record, std::size_t spare = 0) noexcept {
    const std::uint64_t end = end_.load(std::memory_order_relaxed);
    const auto used = static_cast<std::size_t>(end - begin_.load(std::memory_order_acquire));
    if (ring_.size() - used < record.size() + spare) return false;
    end_.store(ring_.put(end, record), std::memory_order_release);
    return true;
  }
  /// By the other: the oldest record, which it takes away, in @p buffer; empty if there is none.
  std::span<const std::byte> pop(RecordBuffer& buffer) noexcept {
    const std::uint64_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return {};
    const auto record = record_at(ring_, begin, buffer);
    begin_.store(begin + record.size(), std::memory_order_release);
    return record;
  }

 private:
  ByteRing ring_;
  std::atomic<std::uint64_t> begin_{0};
  std::atomic<std::uint64_t> end_{0};
};

}  // namespace record
