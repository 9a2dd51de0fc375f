#include <exception>
#include <iostream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "audit/catalogue.hpp"
#include "tools/canopen-audit/command_line/options.hpp"
#include "tools/canopen-audit/report/known_findings.hpp"
#include "tools/canopen-audit/report/report.hpp"
#include "tools/canopen-audit/report/sheet_remarks.hpp"
#include "tools/canopen-audit/rule_page.hpp"
#include "tools/canopen-audit/source/source.hpp"
#include "tools/user_file.hpp"
#include "version/version.hpp"

namespace {

using namespace audit_tool;

audit::Circumstances circumstances_of(const Options& options) {
  audit::Circumstances circumstances{.bit_rate = options.bit_rate};
  for (const Sheet& sheet : options.sheets) {
    eds::Description description =
        eds::read_description(tools::read_user_file(sheet.path), sheet.path, sheet.node);
    if (description.empty()) throw UsageError{sheet.path + ": expected an EDS, found no object in it"};
    circumstances.descriptions.push_back(std::move(description));
  }
  return circumstances;
}

KnownFindings known_of(const Options& options) {
  if (options.known.empty()) return {};
  auto known = KnownFindings::parse(tools::read_user_file(options.known));
  if (!known) throw UsageError{options.known + ": " + known.error()};
  return *std::move(known);
}

/// @p is_cut: the bus was lost.
int status_of(const Verdict& verdict, bool strict, bool is_cut) {
  const bool is_found = verdict.errors != 0 || !verdict.unseen.empty() || (strict && verdict.warnings != 0);
  if (is_found) return kFound;
  return is_cut ? kNotReached : kClean;
}

RunInfo info_of(const Options& options, Hearing& hearing) {
  RunInfo info{.version = std::string{version::number()},
               .source = options.interface ? options.interface->text : options.log,
               .remarks = std::move(hearing.remarks),
               .begin = hearing.begin,
               .end = hearing.end,
               .has_times = hearing.has_times,
               .strict = options.strict,
               .place_word = hearing.place_word};
  for (std::string& remark : sheet_remarks(hearing.auditor->network())) info.remarks.push_back(std::move(remark));
  return info;
}

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw UsageError{"standard output cannot be written"};
}

void write_reports(const Verdict& verdict, const Options& options) {
  print(text_of(verdict, options.time_lines));
  if (!options.junit.empty()) tools::write_user_file(options.junit, junit_of(verdict));
  if (options.json.empty()) return;
  tools::write_user_file(options.json,
                         json_of(verdict).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

int run(const Options& options) {
  KnownFindings known = known_of(options);
  audit::Circumstances circumstances = circumstances_of(options);
  tools::expect_writable(options.junit);
  tools::expect_writable(options.json);
  Hearing hearing = options.interface ? hear_bus(options, std::move(circumstances))
                                      : hear_log(options, std::move(circumstances));
  if (hearing.auditor->frames() == 0) {
    for (const std::string& remark : hearing.remarks) std::cerr << "canopen-audit: " << remark << '\n';
    std::cerr << "canopen-audit: " << hearing.problem << '\n';
    return kNotReached;
  }
  RunInfo info = info_of(options, hearing);
  const Verdict verdict = judge(*hearing.auditor, std::move(info), known);
  write_reports(verdict, options);
  if (!hearing.problem.empty()) std::cerr << "canopen-audit: " << hearing.problem << '\n';
  return status_of(verdict, options.strict, !hearing.problem.empty());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    if (!options) return kClean;
    if (options->list) {
      print(options->markdown ? rules_as_markdown() : rules_as_text());
      return kClean;
    }
    return run(*options);
  } catch (const std::exception& error) {
    std::cerr << "canopen-audit: " << error.what() << '\n';
    return kUsage;
  }
}
