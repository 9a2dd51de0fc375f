#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <linux/can.h>

#include "libcanopen/base/time.hpp"

namespace bench {

/// Frame @p number (from 0 on) of @p sender, 0..255.
can_frame numbered(unsigned sender, std::uint32_t number) noexcept;
/// Who has sent @p frame.
unsigned sender_of(const can_frame& frame) noexcept;
/// Its number among those of the sender.
std::uint32_t number_of(const can_frame& frame) noexcept;

/// The account of somebody who hears the numbered frames of several senders.
class Tally {
 public:
  /// @p senders, each of whom sends @p count frames.
  Tally(std::size_t senders, std::uint32_t count) : next_(senders), expected_{senders * count} {}

  void add(const can_frame& frame, canopen::TimePoint now) noexcept;
  [[nodiscard]] std::uint64_t heard() const noexcept { return heard_; }
  /// Nothing is to come any more, but what was lost.
  [[nodiscard]] bool is_complete() const noexcept { return heard_ >= expected_; }
  /// Frames of @p sender that should have been heard by now, and those in front of them.
  [[nodiscard]] std::uint32_t next_of(std::size_t sender) const noexcept { return next_[sender]; }
  /// The number of frames that the sender who is farthest behind has been heard to send.
  [[nodiscard]] std::uint32_t least() const noexcept;
  /// JSON: frames heard, numbers left out, numbers that came again, a hash of all frames in their order, seconds
  /// from the first to the last.
  [[nodiscard]] std::string report() const;

 private:
  std::vector<std::uint32_t> next_;
  std::uint64_t expected_;
  std::uint64_t heard_ = 0;
  std::uint64_t gaps_ = 0;
  std::uint64_t repeated_ = 0;
  std::uint64_t hash_ = 0xcbf29ce484222325;  // FNV-1a
  canopen::TimePoint first_{};
  canopen::TimePoint last_{};
};

}  // namespace bench
