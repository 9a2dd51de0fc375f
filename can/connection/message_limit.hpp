#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

#include "libcanopen/base/time.hpp"

namespace bus {

/// How often a message of one kind is written that others can cause at will: so many in a period, the rest is
/// counted. Time is told; nothing here reads a clock.
class MessageLimit {
 public:
  /// Messages of a period that are written.
  static constexpr unsigned kMost = 10;
  /// It begins with the first message behind the last period.
  static constexpr canopen::Duration kPeriod = std::chrono::seconds{10};

  /// What becomes of a message.
  enum class Verdict : std::uint8_t {
    Write,
    WriteLast,  ///< the last one of this period: to be said with it
    LeaveOut,   ///< counted
  };

  /// Judges a message that comes at @p now. take_left_out() goes first, so that no count is passed over.
  [[nodiscard]] Verdict judge(canopen::TimePoint now) noexcept {
    if (written_ == 0 || is_over(now)) {
      begin_ = now;
      written_ = 0;
    }
    if (written_ == kMost) {
      ++left_out_;
      return Verdict::LeaveOut;
    }
    return ++written_ == kMost ? Verdict::WriteLast : Verdict::Write;
  }

  /// When the number of messages that were left out is to be told; kNever if none was.
  [[nodiscard]] canopen::TimePoint due() const noexcept {
    return left_out_ == 0 ? canopen::kNever : begin_ + kPeriod;
  }

  /// The number of messages that were left out in a period that is over at @p now, told once; else 0.
  [[nodiscard]] std::uint64_t take_left_out(canopen::TimePoint now) noexcept {
    return is_over(now) ? std::exchange(left_out_, 0) : 0;
  }

 private:
  [[nodiscard]] bool is_over(canopen::TimePoint now) const noexcept { return now - begin_ >= kPeriod; }

  canopen::TimePoint begin_{};
  unsigned written_ = 0;  ///< in the period since begin_
  std::uint64_t left_out_ = 0;
};

}  // namespace bus
