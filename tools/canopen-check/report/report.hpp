#pragma once

#include <chrono>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tools/canopen-check/core/run/runner.hpp"

namespace conformance {

/// What a report says about the run as a whole.
struct RunInfo {
  std::string version{};
  std::string interface {};  ///< as given; empty for a static run
  unsigned node_id = 0;
  std::string mode{};
  std::string eds{};     ///< files, separated by blanks
  std::string device{};  ///< "vendor 000000BDh, product 00000001h, revision 00010000h"; as the EDS says
};

/// The word for @p mode.
[[nodiscard]] std::string_view word_of(Mode mode) noexcept;

/// @p frame in the form of candump's log, its time counted from @p begin: "(000001.234567) vcan0
/// 605#4000100000000000".
[[nodiscard]] std::string frame_text(const TimedFrame& frame, canopen::TimePoint begin,
                                     const std::string& interface);

/// @p time in seconds, as reports give it.
[[nodiscard]] inline double seconds(canopen::Duration time) noexcept {
  return std::chrono::duration<double>{time}.count();
}

/// One line that says what became of a check, without line end.
[[nodiscard]] std::string line_of(const CheckResult& result);
/// What it found, noted, sent and received: no or several lines, each with its end.
[[nodiscard]] std::string details_of(const CheckResult& result, const RunInfo& info);
/// The table of groups and the sums, with what was not restored.
[[nodiscard]] std::string summary_of(const RunReport& report);

/// The report as JUnit XML (testsuites, a testsuite a group, a testcase a check).
[[nodiscard]] std::string junit_of(const RunReport& report, const RunInfo& info);
/// The report as JSON; docs/reference/conformance.md says what is in it.
[[nodiscard]] nlohmann::json json_of(const RunReport& report, const RunInfo& info);

}  // namespace conformance
