#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "injection/language/fault.hpp"
#include "injection/language/random.hpp"
#include "libcanopen/base/time.hpp"

namespace injection {

/// Where a fault is in its life.
enum class Phase : std::uint8_t { Waiting, Active, Over };
inline constexpr auto kPhaseNames = std::to_array<std::string_view>({"waiting", "active", "over"});

/// Decides which opportunities of a fault are hit, and counts. Of what happens, everything is told in this order:
/// note(), on_opportunity() if the fault could act on it, and note_healthy() if it has not.
class Trigger {
 public:
  /// Opportunities whose numbers are kept, the first ones that were hit.
  static constexpr std::size_t kKept = 16;

  /// Of @p fault, which was injected at @p now.
  Trigger(const Fault& fault, canopen::TimePoint now) noexcept;

  /// Something has happened.
  void note(const Occurrence& occurrence, canopen::TimePoint now) noexcept;
  /// The fault could act on what happens, in a state that lets it (`while`): whether it does.
  bool on_opportunity(canopen::TimePoint now) noexcept;
  /// Something has happened that was not hit.
  void note_healthy(const Occurrence& occurrence) noexcept;
  /// deadline() may have come.
  void on_time(canopen::TimePoint now) noexcept;
  /// What a hit of a lasting fault has begun is over.
  void end_hit() noexcept;

  Phase phase() const noexcept { return phase_; }
  /// When on_time() is wanted; kNever: not at all.
  canopen::TimePoint deadline() const noexcept { return phase_ != Phase::Over ? deadline_ : canopen::kNever; }
  /// Of Nature::Lasting: it holds now.
  bool holds() const noexcept { return holds_ && phase_ != Phase::Over; }

  /// Events that `after` counts, opportunities behind them, and hits.
  std::uint64_t events() const noexcept { return events_; }
  std::uint64_t opportunities() const noexcept { return opportunities_; }
  std::uint64_t hits() const noexcept { return hits_; }
  /// The numbers of the first opportunities that were hit, from 1.
  std::span<const std::uint64_t> hit_at() const noexcept { return {hit_at_.data(), kept_}; }

 private:
  void activate(canopen::TimePoint now) noexcept;
  bool draws_hit() noexcept;
  void count_hit(canopen::TimePoint now) noexcept;

  When when_;
  Nature nature_;
  Random random_;
  Phase phase_ = Phase::Waiting;
  bool holds_ = false;
  std::uint32_t most_hits_;  ///< 0: any number
  std::uint32_t healthy_ = 0;
  std::uint64_t events_ = 0;
  std::uint64_t opportunities_ = 0;
  std::uint64_t hits_ = 0;
  std::size_t kept_ = 0;
  std::array<std::uint64_t, kKept> hit_at_{};
  canopen::TimePoint deadline_ = canopen::kNever;
};

}  // namespace injection
