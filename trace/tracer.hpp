#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"
#include "trace/recording.hpp"
#include "trace/settings.hpp"
#include "trace/signal/problem.hpp"
#include "trace/signal/signal.hpp"
#include "unit/cycle_clock.hpp"

namespace trace {

/// What a trace does.
enum class Phase : std::uint8_t {
  Off,        ///< nothing was asked for
  Waiting,    ///< for the trigger
  Recording,  ///< the trigger was there
  Done,       ///< all is recorded, or it was stopped
};

/// "off", "waiting", "recording", "done".
std::string_view name_of(Phase phase) noexcept;

/// Traces signals of a drive unit step by step, with its frames and events. While it is_on() it has to be told
/// all of them: as observer of the unit's cycles and by on_frame() and on_event(). Nothing is allocated but by
/// start().
class Tracer final : public unit::CycleObserver {
 public:
  /// @p unit outlives this.
  explicit Tracer(const drive::DriveUnit& unit) noexcept;
  ~Tracer() override;
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// Begins with what @p settings say, in a unit with cycles of @p cycle; the results of the trace before are
  /// forgotten. With a problem nothing changes.
  tl::expected<void, Problem> start(const Settings& settings, unit::Duration cycle);
  /// Ends what runs; what was recorded is a result, with or without a trigger.
  void stop() noexcept;

  Phase phase() const noexcept { return phase_; }
  bool is_on() const noexcept { return phase_ == Phase::Waiting || phase_ == Phase::Recording; }
  /// What was asked for; not to be called in Phase::Off.
  const Settings& settings() const noexcept;
  std::span<const Signal> signals() const noexcept;
  /// What is being recorded; nullptr unless it is_on().
  const Recording* current() const noexcept;
  /// The numbers of the results that are there, from 1 on in the order of their recording, are first..last;
  /// last = 0: none.
  struct Results {
    std::uint64_t first = 1;
    std::uint64_t last = 0;
  };
  Results results() const noexcept;
  /// Result @p number, one of results().
  const Recording* result(std::uint64_t number) const noexcept;

  void on_cycle_begin(unit::TimePoint begin) noexcept override;
  void on_step(long step) noexcept override;
  void on_cycle_end() noexcept override;
  void on_frame(const Frame& frame) noexcept;
  void on_event(const Event& event) noexcept;

 private:
  struct Armed;

  void look(unit::TimePoint now) noexcept;
  void advance(unit::TimePoint now, bool at_cycle_end) noexcept;
  void trigger(unit::TimePoint time) noexcept;
  void finish() noexcept;

  const drive::DriveUnit& unit_;
  std::unique_ptr<Armed> armed_;
  Phase phase_ = Phase::Off;
  unit::TimePoint begin_{};  ///< of the cycle that runs
  long steps_ = 0;           ///< that it has done
};

}  // namespace trace
