#pragma once

#include "eds/description/description.hpp"
#include "tools/axisctl/runs/fidelity/bands.hpp"
#include "tools/axisctl/runs/fidelity/finding.hpp"
#include "tools/axisctl/runs/fidelity/known_differences.hpp"

namespace runs {

/// By what a course is judged.
struct Yardstick {
  eds::Description description{};
  Bands bands{};
  KnownDifferences known{};
  canopen::Duration time = std::chrono::milliseconds{20};  ///< by which times may differ
  double time_share = 0.05;  ///< and this share of what has passed since the last frame of the master
  double speed = 1.0;        ///< of the run, in times of that of the log
};

/// Takes down what was compared.
class Verdict {
 public:
  explicit Verdict(const KnownDifferences& known) : known_{known} {}

  void add_same(Aspect aspect);
  void add_within(Aspect aspect);
  /// A difference; it is known if the list has it.
  void add(Finding finding);
  [[nodiscard]] Fidelity& fidelity() noexcept { return fidelity_; }

 private:
  /// Findings that are kept.
  static constexpr std::size_t kMostFindings = 500;

  const KnownDifferences& known_;
  Fidelity fidelity_{};
};

}  // namespace runs
