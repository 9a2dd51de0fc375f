#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "audit/auditor.hpp"
#include "tools/canopen-audit/report/known_findings.hpp"

namespace audit_tool {

/// What a report says of the run as a whole.
struct RunInfo {
  std::string version{};
  std::string source{};                ///< the log, or the interface
  std::vector<std::string> remarks{};  ///< gaps, damaged lines, an EDS that does not fit: a line each
  canopen::Duration begin{}, end{};    ///< of the first and the last frame
  bool has_times = true;
  bool strict = false;                    ///< a warning is a failure, too
  std::string_view place_word = "frame";  ///< what the place of a frame counts
};

/// A finding with why it is known; empty: it is not.
struct Judged {
  const audit::Finding* finding = nullptr;
  std::string known{};
};

/// What came of an audit.
struct Verdict {
  const audit::Auditor* auditor = nullptr;
  RunInfo info{};
  std::vector<Judged> findings{};     ///< those that are kept, by rule in the order of the docs, then by time
  std::vector<std::string> unseen{};  ///< known findings that were not found, in words
  /// How often rules were broken. What is not kept is known if all findings of that rule and node are.
  std::uint64_t errors = 0, warnings = 0, known = 0;
};

/// Judges what @p auditor has found; it outlives the verdict.
[[nodiscard]] Verdict judge(const audit::Auditor& auditor, RunInfo info, KnownFindings& known);

/// @p time in seconds.
[[nodiscard]] constexpr double seconds(canopen::Duration time) noexcept {
  return std::chrono::duration<double>{time}.count();
}
/// "(0012.345678) can0 605#4000100000000000": with the time since @p begin.
[[nodiscard]] std::string frame_text(const audit::Heard& heard, canopen::Duration begin);
/// What the frame at @p position of the evidence of @p finding says: "SDO request to node 5: read 1000h:00".
[[nodiscard]] std::string frame_words(const audit::Finding& finding, std::size_t position,
                                      const audit::Network& network);

/// The report for people.
[[nodiscard]] std::string text_of(const Verdict& verdict, bool with_time_lines);
/// The same for programs; docs/reference/canopen-audit.md says what is in it.
[[nodiscard]] nlohmann::json json_of(const Verdict& verdict);
/// The same as JUnit XML: a testsuite a group of rules, a testcase a rule.
[[nodiscard]] std::string junit_of(const Verdict& verdict);

}  // namespace audit_tool
