#pragma once

#include <cstdint>
#include <optional>

#include "can/hub/trunk/lease/lease.hpp"
#include "libcanopen/base/time.hpp"

namespace hub::trunk {

/// When a hub takes the lease of the arbiter: when nothing has come from one for a time, and nobody has taken the
/// lease meanwhile who may not have spoken yet.
class Candidate {
 public:
  /// The lease is looked at after so long without an arbiter: on a bus that has one, nobody gets so far.
  static constexpr canopen::Duration kLookAfter = std::chrono::milliseconds{100};
  /// Between two looks whether there is an answer.
  static constexpr canopen::Duration kLook = std::chrono::milliseconds{5};

  /// @p lease outlives this; @p hub is this hub's number, @p patience the time that an arbiter may be silent.
  Candidate(Lease& lease, std::uint32_t hub, canopen::Duration patience) noexcept
      : lease_{lease}, hub_{hub}, patience_{patience} {}

  /// Nothing has been heard of an arbiter so far.
  void begin(canopen::TimePoint now) noexcept;
  /// There is one at @p now.
  void on_arbiter(canopen::TimePoint now) noexcept { quiet_since_ = now; }
  /// There was one, whose term is over.
  void on_end(canopen::TimePoint now) noexcept { quiet_since_ = now - patience_; }
  /// When there is none any more, unless it is heard of before.
  [[nodiscard]] canopen::TimePoint quiet_at() const noexcept { return quiet_since_ + patience_; }

  /// Seeks the lease where it may; the term for which it has been gained, above @p known, the last one that was
  /// heard of.
  std::optional<std::uint32_t> seek(std::uint32_t known, canopen::TimePoint now) noexcept;
  /// When seek() is wanted.
  [[nodiscard]] canopen::TimePoint next_deadline(std::uint32_t known) const noexcept;

 private:
  [[nodiscard]] std::optional<std::uint32_t> take_answer(canopen::TimePoint now) noexcept;

  Lease& lease_;
  std::uint32_t hub_;
  canopen::Duration patience_;
  canopen::TimePoint quiet_since_{};
  std::optional<Lease::Entry> entry_;  ///< as it was seen last
  canopen::TimePoint entry_since_{};   ///< from when on it has been so
  bool is_asking_ = false;
  canopen::TimePoint next_look_{};  ///< for an answer
  std::uint32_t wanted_ = 0;        ///< term for which the lease is being taken
};

}  // namespace hub::trunk
