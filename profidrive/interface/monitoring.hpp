#pragma once

#include <cstdint>

#include "unit/time.hpp"

namespace profidrive {

/// Whether process data keep coming: behind p2040 and p2047 the setpoints have failed (A01920), behind p2044 that
/// is a fault (F01910).
class Monitoring {
 public:
  enum class Stage : std::uint8_t {
    Off,          ///< nothing has come yet
    Running,      ///< process data are exchanged
    Interrupted,  ///< they have failed
    Failed        ///< for so long that it is a fault; until something comes
  };
  /// p2040, p2047 and p2044; a limit of zero: nothing ever fails.
  struct Times {
    unit::Duration limit{};
    unit::Duration further{};
    unit::Duration fault_delay{};
  };

  /// Process data have come at @p now.
  void receive(unit::TimePoint now, const Times& times) noexcept {
    stage_ = Stage::Running;
    times_ = times;
    due_ = times.limit > unit::Duration::zero() ? now + times.limit + times.further : unit::kNever;
  }
  /// Somebody has looked at them.
  void touch(unit::TimePoint now) noexcept {
    if (stage_ == Stage::Running || stage_ == Stage::Interrupted) receive(now, times_);
  }
  /// Goes on to the stage of @p now by one; true if it is another one.
  bool advance(unit::TimePoint now) noexcept {
    if (now < due_) return false;
    const bool was_running = stage_ == Stage::Running;
    stage_ = was_running ? Stage::Interrupted : Stage::Failed;
    due_ = was_running ? due_ + times_.fault_delay : unit::kNever;
    return true;
  }
  void stop() noexcept { *this = {}; }

  Stage stage() const noexcept { return stage_; }
  /// Whether a time runs.
  bool waits() const noexcept { return due_ != unit::kNever; }

 private:
  Stage stage_ = Stage::Off;
  Times times_{};
  unit::TimePoint due_ = unit::kNever;
};

}  // namespace profidrive
