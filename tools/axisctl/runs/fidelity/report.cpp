#include "tools/axisctl/runs/fidelity/report.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace runs {
namespace {

using nlohmann::json;

double seconds_of(canopen::Duration time) {
  return std::chrono::duration<double>{time}.count();
}

double milliseconds_of(canopen::Duration time) {
  return std::chrono::duration<double, std::milli>{time}.count();
}

std::string finding_text(const Finding& finding) {
  const std::string place = finding.place == 0 ? "-" : fmt::format("line {}", finding.place);
  std::string text = fmt::format("  {:>10} {:11.6f} s  {}\n", place, seconds_of(finding.at), finding.what);
  text += fmt::format("  {:>10} {:>13}  {}: the log has {}, the run {}\n", "", "",
                      kNatures[static_cast<std::size_t>(finding.nature)], finding.log, finding.run);
  if (!finding.known.empty()) text += fmt::format("  {:>10} {:>13}  known, {}\n", "", "", finding.known);
  return text;
}

std::string times_text(std::string_view whose, const std::optional<AnswerTimes>& times) {
  if (!times) return "";
  return fmt::format("  {:<8} {:9.3f} {:9.3f} {:9.3f}\n", whose, milliseconds_of(times->median),
                     milliseconds_of(times->most_of), milliseconds_of(times->longest));
}

json times_json(const std::optional<AnswerTimes>& times) {
  if (!times) return nullptr;
  return {{"median_s", seconds_of(times->median)},
          {"p99_s", seconds_of(times->most_of)},
          {"longest_s", seconds_of(times->longest)}};
}

json finding_json(const Finding& finding) {
  json value{{"aspect", name_of(finding.aspect).key},
             {"difference", kNatures[static_cast<std::size_t>(finding.nature)]},
             {"t_s", seconds_of(finding.at)},
             {"what", finding.what},
             {"log", finding.log},
             {"run", finding.run}};
  if (finding.place != 0) value["place"] = finding.place;
  if (finding.object)
    value["object"] = fmt::format("{:04X}h:{:02X}", finding.object->index, finding.object->sub_index);
  if (!finding.known.empty()) value["known"] = finding.known;
  return value;
}

}  // namespace

std::string text_of(const Fidelity& fidelity, std::size_t most) {
  std::string text = fmt::format("{:<26}{:>9}{:>9}{:>9}{:>10}{:>8}{:>9}\n", "", "compared", "same", "within",
                                 "different", "known", "missing");
  for (const AspectName& row : kAspects) {
    const Tally& tally = fidelity.tallies[static_cast<std::size_t>(row.aspect)];
    if (tally.compared == 0) continue;
    text += fmt::format("{:<26}{:>9}{:>9}{:>9}{:>10}{:>8}{:>9}\n", row.text, tally.compared, tally.same,
                        tally.within, tally.different, tally.known, tally.missing);
  }
  if (fidelity.run_times) {
    text +=
        fmt::format("SDO answers came after (ms)\n  {:<8} {:>9} {:>9} {:>9}\n", "", "median", "99 %", "longest");
    text += times_text("the log", fidelity.log_times) + times_text("the run", fidelity.run_times);
  }
  if (!fidelity.findings.empty()) text += "differences:\n";
  for (std::size_t i = 0; i < std::min(most, fidelity.findings.size()); ++i)
    text += finding_text(fidelity.findings[i]);
  const std::uint64_t more =
      fidelity.left_out + (fidelity.findings.size() > most ? fidelity.findings.size() - most : 0);
  return more == 0 ? text : text + fmt::format("  and {} more\n", more);
}

json json_of(const Fidelity& fidelity) {
  json value{{"aspects", json::object()}, {"differences", json::array()}, {"left_out", fidelity.left_out}};
  for (const AspectName& row : kAspects) {
    const Tally& tally = fidelity.tallies[static_cast<std::size_t>(row.aspect)];
    value["aspects"][std::string{row.key}] = {{"compared", tally.compared}, {"same", tally.same},
                                              {"within", tally.within},     {"different", tally.different},
                                              {"known", tally.known},       {"missing", tally.missing}};
  }
  for (const Finding& finding : fidelity.findings) value["differences"].push_back(finding_json(finding));
  value["answer_times"] = {{"log", times_json(fidelity.log_times)}, {"run", times_json(fidelity.run_times)}};
  value["unknown"] = fidelity.unknown();
  return value;
}

std::string text_of(const ReplayFigures& figures) {
  std::string text =
      fmt::format("{} frames sent in {:.3f} s; {} of {} answers came", figures.sent, seconds_of(figures.length),
                  figures.answers - figures.unanswered, figures.answers);
  if (figures.late > canopen::Duration::zero()) text += fmt::format("; {:.3f} s late", seconds_of(figures.late));
  if (figures.left_out > 0) text += fmt::format("; {} frames of others left out", figures.left_out);
  if (figures.refused > 0) text += fmt::format("; {} frames that the bus does not carry", figures.refused);
  return text;
}

json json_of(const ReplayFigures& figures) {
  return {{"sent", figures.sent},
          {"answers", figures.answers},
          {"unanswered", figures.unanswered},
          {"left_out", figures.left_out},
          {"refused", figures.refused},
          {"late_s", seconds_of(figures.late)},
          {"length_s", seconds_of(figures.length)}};
}

}  // namespace runs
