#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/scenario/report/report.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace scenario {
namespace {

const char* mark_of(StepResult::Kind kind) {
  switch (kind) {
    case StepResult::Kind::Passed:
      return "✓";
    case StepResult::Kind::Failed:
      return "✗";
    case StepResult::Kind::NotRun:
      break;
  }
  return "-";
}

std::string line_of(const StepResult& result) {
  const Step& step = *result.step;
  const std::string name = step.keys.value("name", "");
  const std::string about = step.keys.value("about", "");
  const std::string time = result.kind == StepResult::Kind::NotRun && result.text.empty()
                               ? std::string(8, ' ')
                               : fmt::format("{:8.3f}", result.begin_s);
  std::string line = fmt::format("  {} {} {:>3}  {}{}", time, mark_of(result.kind), step.number,
                                 name.empty() ? "" : name + ": ", step.text);
  if (!result.text.empty()) line += fmt::format("  [{}]", result.text);
  if (!about.empty()) line += fmt::format("\n{:17}{}", "", about);
  return line;
}

std::string frames_of(const RunResult& result) {
  std::string text = "last frames (-> sent by the scenario):\n";
  for (const conformance::TimedFrame& frame : result.frames)
    text += fmt::format(
        "  {:9.3f} {} {:<24} {}\n", std::chrono::duration<double>(frame.time.time_since_epoch()).count(),
        frame.sent ? "->" : "<-", conformance::to_text(frame.frame), meaning::service_of(frame.frame));
  return text;
}

}  // namespace

std::string text_of(const Scenario& scenario, const RunResult& result) {
  std::string text = fmt::format("{}: {}\n  seed {}, bus {}\n", scenario.name, axisctl::printable(scenario.title),
                                 scenario.seed, result.bus.empty() ? "none" : result.bus);
  for (const StepResult& step : result.steps) {
    const std::string line = line_of(step);
    const std::size_t end = line.find('\n');
    text += axisctl::printable(line.substr(0, end)) + '\n';
    if (end != std::string::npos) text += axisctl::printable(line.substr(end + 1)) + '\n';
  }
  for (const nlohmann::json& fault : result.faults)
    text +=
        axisctl::printable(fmt::format("  fault {} ({}): {} hits of {} opportunities, {}", fault.value("name", ""),
                                       fault.value("kind", ""), fault.value("hits", 0),
                                       fault.value("opportunities", 0), fault.value("state", ""))) +
        '\n';
  if (!result.passed) {
    if (!result.problem.empty()) text += axisctl::printable(result.problem) + '\n';
    if (!result.frames.empty()) text += frames_of(result);
    for (const std::string& note : result.notes) text += axisctl::printable(note) + '\n';
  }
  return text +
         fmt::format("{} {} in {:.3f} s\n", scenario.name, result.passed ? "passed" : "failed", result.seconds);
}

}  // namespace scenario
