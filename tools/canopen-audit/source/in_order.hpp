#pragma once

#include <chrono>
#include <cstddef>
#include <deque>

#include "audit/auditor.hpp"

namespace audit_tool {

/// Hands frames to an auditor in the order of their times. Where the bus is a virtual one of the kernel, two
/// senders on two processors may reach a socket the other way round: an answer before its request.
class InOrder {
 public:
  /// How much later than others a frame may come and still get its place.
  static constexpr canopen::Duration kWindow = std::chrono::milliseconds{200};
  /// Frames that are kept for that; with more the earliest ones go on.
  static constexpr std::size_t kMostKept = 65536;

  /// @p auditor outlives this.
  explicit InOrder(audit::Auditor& auditor) noexcept : auditor_{auditor} {}

  /// A frame that has come. Where times go back by more than kWindow they are counted on from the one before.
  void add(const audit::Heard& heard);
  /// Nothing that was added is waited for any longer.
  void flush();
  /// Time of the first and of the last frame so far.
  [[nodiscard]] canopen::Duration begin() const noexcept { return begin_; }
  [[nodiscard]] canopen::Duration end() const noexcept { return end_; }

 private:
  void hand_over(std::size_t count);

  audit::Auditor& auditor_;
  std::deque<audit::Heard> kept_{};  ///< by time, then as they came
  canopen::Duration offset_{};       ///< by which times that have gone back are too small
  canopen::Duration begin_{}, end_{};
};

}  // namespace audit_tool
