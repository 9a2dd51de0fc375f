#pragma once

#include <map>

#include "tools/axisctl/runs/log/log_reader.hpp"
#include "tools/axisctl/runs/replay/course.hpp"
#include "tools/canopen-check/core/wire.hpp"

namespace runs {

/// How a log is played.
struct ReplayOptions {
  double speed = 1.0;                                      ///< so many times as fast, above 0
  canopen::Duration patience = std::chrono::seconds{1};    ///< with an answer that the log has
  canopen::Duration rest = std::chrono::milliseconds{50};  ///< behind the last frame of the log
  bool keeps_courses = false;                              ///< log() and run() have what has passed
};

/// What came of it.
struct ReplayFigures {
  std::uint64_t sent = 0;        ///< frames of the master
  std::uint64_t answers = 0;     ///< SDO answers and boot-up messages that the log has
  std::uint64_t unanswered = 0;  ///< of these, those for which the unit was waited for in vain
  std::uint64_t left_out = 0;    ///< frames of nobody who is known, and errors
  std::uint64_t refused = 0;     ///< frames that the bus does not carry
  canopen::Duration late{};      ///< by which the end came later than in the log
  canopen::Duration length{};    ///< from the first frame of the master to the end
};

/// Plays the master's side of a log against a unit. A frame goes out when it is due: as far behind the one before
/// it as in the log, and not before the unit has answered what it has answered before that in the log.
class Replay {
 public:
  /// Time and frames are those of @p wire, which outlives this.
  Replay(conformance::Wire& wire, Nodes units, const meaning::CobIds& ids, const ReplayOptions& options)
      : wire_{wire}, side_{units, ids}, heard_{units, ids}, options_{options} {}

  /// Plays @p log from its beginning to its end. ExitStatus::CutOff if the bus goes down, ExitStatus::Failed after
  /// a signal.
  [[nodiscard]] Expected<void> play(LogReader& log);

  [[nodiscard]] const ReplayFigures& figures() const noexcept { return figures_; }
  /// What the log has, and what has come of it now.
  [[nodiscard]] Course& log() noexcept { return log_; }
  [[nodiscard]] Course& run() noexcept { return run_; }

 private:
  [[nodiscard]] Expected<void> present(const LoggedFrame& logged, const MasterSide::Judgement& judgement);
  [[nodiscard]] Expected<void> await_answers();
  [[nodiscard]] Expected<void> pass(canopen::TimePoint until);
  void hear(const conformance::TimedFrame& frame);
  [[nodiscard]] Expected<void> state() const;
  /// When something of the log is due that came at @p at.
  [[nodiscard]] canopen::TimePoint due(std::chrono::nanoseconds at) const noexcept;

  conformance::Wire& wire_;
  MasterSide side_, heard_;
  ReplayOptions options_;
  ReplayFigures figures_{};
  Course log_{}, run_{};
  bool has_begun_ = false;
  std::chrono::nanoseconds first_{}, last_{};  ///< of the log: the first frame of the master, the last frame
  canopen::TimePoint begin_{};                 ///< of the run, less what it was late
  canopen::TimePoint begun_{};                 ///< of the run
  std::map<meaning::Meaning, std::uint64_t> owed_, given_;  ///< answers of the log, and of the unit
};

}  // namespace runs
