#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/run/deviations.hpp"
#include "tools/canopen-check/core/run/snapshot.hpp"

namespace conformance {

/// Told of what goes on.
struct Progress {
  std::function<void(const Check&, std::size_t number, std::size_t total)> begin = [](auto&&...) {};
  std::function<void(const CheckResult&)> end = [](auto&&...) {};
  /// Once, of the checks that could not be run any more.
  std::function<void(std::size_t count, const std::string& reason)> left_out = [](auto&&...) {};
};

/// What came of a run.
struct RunReport {
  std::vector<CheckResult> results{};
  bool reached = false;                     ///< the node answered
  bool cut_short = false;                   ///< it ended before its last check: `problem`
  std::string problem{};                    ///< why it was not reached, or was lost
  std::vector<std::string> not_restored{};  ///< entries that do not hold what they held before
  std::vector<std::string> notes{};         ///< what was restored
  canopen::Duration time{};

  [[nodiscard]] std::size_t count(Outcome outcome) const noexcept;
};

/// Runs checks against a node, one after the other, and leaves it as it was.
class Runner {
 public:
  /// @p wire, @p eds, @p settings and @p deviations must outlive it.
  Runner(Wire& wire, const eds::Description& eds, const Settings& settings, Deviations& deviations);

  /// Runs @p checks in their order; those that settings or mode do not allow are skipped.
  RunReport run(std::span<const Check* const> checks, const Progress& progress);

 private:
  /// True once the node has answered an upload of 1000h.
  bool reach(RunReport& report);
  /// Finds out the state in which the node is, and commands Pre-operational.
  void explore();
  CheckResult run_check(const Check& check);
  void perform(const Check& check, CheckResult& result);
  void restore(Context& context, CheckResult& result);
  /// Runs a check that failed in Operational again if the node has come to refuse that state; the first one that
  /// passed is looked at likewise.
  void judge_operational(const Check& check, CheckResult& result);
  /// Finds out why the node refuses Operational now, if it does.
  void ask_for_operational();
  /// A finding if the node does not answer any more.
  void judge_presence(CheckResult& result);
  /// What follows from a check for those behind it: why they cannot run, or nothing.
  [[nodiscard]] std::string consequence(const Check& check, RunReport& report);
  /// True if the node, which is gone, answers again after a reset.
  bool revive();
  bool answers(int attempts);
  /// Why nothing must be written: the node says by 1018h that the EDS is of another device. Else empty.
  [[nodiscard]] std::string foreign_device();
  /// Makes the node ready for what is written back: from here on an interruption is passed over.
  void take_over();
  void finish(RunReport& report, Snapshot& snapshot);
  /// Checks that store and load leave factory settings behind: what the node works with is stored instead.
  void store_again(RunReport& report);
  [[nodiscard]] std::string why_not(const Check& check) const;
  [[nodiscard]] std::string trouble() const;

  Session session_;
  SdoClient sdo_;
  const eds::Description* eds_;
  const Settings* settings_;
  Deviations* deviations_;
  Manners manners_{};
  bool gone_ = false;             ///< the node does not answer
  bool was_operational_ = false;  ///< the last check has entered Operational
  std::string over_{};            ///< why further checks cannot run
  std::string foreign_;
  canopen::NmtState initial_state_ = canopen::NmtState::PreOperational;
};

}  // namespace conformance
