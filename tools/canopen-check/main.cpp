#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "eds/document/document.hpp"
#include "eds/lint/lint.hpp"
#include "tools/canopen-check/checks/objects/static_checks.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/options.hpp"
#include "tools/canopen-check/port_wire.hpp"
#include "tools/canopen-check/report/report.hpp"
#include "tools/user_file.hpp"
#include "version/version.hpp"

namespace {

using namespace conformance;

/// The EDS files: what they say, and what is wrong with them.
struct Sheets {
  eds::Description description;
  std::vector<eds::Finding> findings;
  std::string names;

  explicit Sheets(const Options& options) {
    for (const std::string& path : options.eds_files) {
      const std::string text = tools::read_user_file(path);
      for (const eds::Finding& finding : eds::lint(text, path).all()) findings.push_back(finding);
      eds::Findings of_reading{path};
      const eds::Document document = eds::read_document(text, of_reading);
      description.add(eds::read_data_sheet(document, of_reading), options.settings.node_id);
      names += (names.empty() ? "" : " ") + path;
    }
    if (!options.eds_files.empty() && description.empty())
      throw UsageError{names + ": expected an EDS, found no object in it"};
  }
};

std::string hexadecimal_of(const std::optional<std::uint64_t>& number) {
  return number ? fmt::format("{:08X}h", *number) : "not stated";
}

RunInfo info_of(const Options& options, const Sheets& sheets) {
  const eds::DeviceFacts& device = sheets.description.device();
  return {.version = std::string{version::number()},
          .interface = options.interface ? options.interface->text : "",
          .node_id = options.interface ? options.settings.node_id : 0U,
          .mode = std::string{word_of(options.settings.mode)},
          .eds = sheets.names,
          .device = sheets.names.empty()
                        ? ""
                        : fmt::format("{}: vendor {}, product {}, revision {}", device.name,
                                      hexadecimal_of(device.vendor), hexadecimal_of(device.product),
                                      hexadecimal_of(device.revision))};
}

void print_list(bool markdown) {
  const auto print = [markdown](const Check& check) {
    if (markdown)
      std::cout << fmt::format("| `{}` | {} | {} | {}{}{} |\n", check.id, check.name, check.clause,
                               word_of(check.mode), check.stores ? ", --allow-store" : "",
                               check.moves ? ", --allow-motion" : "");
    else
      std::cout << fmt::format("{:<44} {:<10} {} ({}){}{}\n", check.id, word_of(check.mode), check.name,
                               check.clause, check.stores ? ", needs --allow-store" : "",
                               check.moves ? ", needs --allow-motion" : "");
  };
  for (const Check& check : static_checks()) print(check);
  for (const Check* const check : all_checks()) print(*check);
}

/// Prints what goes on: a line for each check, and on a terminal which one runs.
class Printer {
 public:
  Printer(const Options& options, const RunInfo& info)
      : verbose_{options.verbose}, terminal_{::isatty(STDERR_FILENO) == 1}, info_{&info} {}

  void begin(const Check& check, std::size_t number, std::size_t total) const {
    if (terminal_) std::cerr << fmt::format("\r\033[K[{}/{}] {}", number, total, check.id) << std::flush;
  }
  void end(const CheckResult& result) const {
    if (terminal_) std::cerr << "\r\033[K" << std::flush;
    std::cout << line_of(result) << '\n';
    const bool bare = result.outcome == Outcome::Passed || result.outcome == Outcome::Skipped;
    if (!bare || verbose_) std::cout << details_of(result, *info_);
    std::cout << std::flush;
  }
  static void left_out(std::size_t count, const std::string& reason) {
    std::cout << fmt::format("{:<9} {} further checks: {}\n", word_of(Outcome::Skipped), count, reason)
              << std::flush;
  }

 private:
  bool verbose_;
  bool terminal_;
  const RunInfo* info_;
};

int status_of(const RunReport& report) {
  if (report.cut_short || report.count(Outcome::Failed) + report.count(Outcome::Broken) != 0 ||
      !report.not_restored.empty())
    return kFound;
  return report.count(Outcome::Passed) + report.count(Outcome::Deviates) == 0 ? kNotReached : kClean;
}

/// Runs what needs the node. A bus that cannot be opened is a problem of the report.
RunReport test_node(const Options& options, const Sheets& sheets, Deviations& deviations, const Printer& printer) {
  std::vector<const Check*> wanted;
  for (const Check* const check : all_checks())
    if (is_wanted(options, *check)) wanted.push_back(check);
  take_signals();
  std::unique_ptr<PortWire> wire;
  try {
    wire = std::make_unique<PortWire>(*options.interface);
  } catch (const std::exception& error) {
    return {.problem = error.what()};
  }
  Runner runner{*wire, sheets.description, options.settings, deviations};
  return runner.run(wanted, {.begin = [&](const Check& check, std::size_t number,
                                          std::size_t total) { printer.begin(check, number, total); },
                             .end = [&](const CheckResult& result) { printer.end(result); },
                             .left_out = [](std::size_t count,
                                            const std::string& reason) { Printer::left_out(count, reason); }});
}

int run(const Options& options) {
  Deviations deviations;
  if (!options.deviations.empty()) {
    tl::expected<Deviations, std::string> read = Deviations::parse(tools::read_user_file(options.deviations));
    if (!read) throw UsageError{options.deviations + ": " + read.error()};
    deviations = std::move(*read);
  }
  const Sheets sheets{options};
  tools::expect_writable(options.junit);
  tools::expect_writable(options.json);
  const RunInfo info = info_of(options, sheets);
  const Printer printer{options, info};
  RunReport report;
  std::vector<CheckResult> of_files;
  if (!options.eds_files.empty())
    for (CheckResult& result : judge_files(sheets.findings)) {
      const bool left_out = std::ranges::any_of(
          options.settings.skip, [&](const std::string& word) { return is_named(*result.check, word); });
      if (!is_wanted(options, *result.check) || left_out) continue;
      deviations.judge(result);
      if (result.outcome != Outcome::Passed || options.verbose) printer.end(result);
      of_files.push_back(std::move(result));
    }
  if (options.interface) report = test_node(options, sheets, deviations, printer);
  report.results.insert(report.results.begin(), of_files.begin(), of_files.end());
  if (!options.junit.empty()) tools::write_user_file(options.junit, junit_of(report, info));
  if (!options.json.empty())
    tools::write_user_file(
        options.json, json_of(report, info).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  std::cout << summary_of(report);
  if (!report.problem.empty()) std::cerr << "canopen-check: " << report.problem << '\n';
  if (options.interface && !report.reached) return kNotReached;
  return status_of(report);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    if (!options) return kClean;
    if (options->list) {
      print_list(options->markdown);
      return kClean;
    }
    return run(*options);
  } catch (const std::exception& error) {
    std::cerr << "canopen-check: " << error.what() << '\n';
    return kUsage;
  }
}
