#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include <CLI/CLI.hpp>

#include "eds/document/encoding.hpp"
#include "eds/document/finding_filter.hpp"
#include "eds/lint/check_table.hpp"
#include "eds/lint/lint.hpp"
#include "tools/edstool/command.hpp"

namespace edstool {
namespace {

using nlohmann::json;

struct LintOptions {
  std::vector<std::string> files;
  std::string severity = "warning";  ///< the least one that is told of
  std::vector<std::string> ignored;  ///< CHECK or CHECK:SECTION
  std::string ignore_list;           ///< path of a file of them, a line each
  bool all = false;                  ///< warnings that are alike, one by one
};

/// A check that is not to be told of; @p source says where the words come from. UsageError.
eds::IgnoredCheck ignored_check(const std::string& text, const std::string& source) {
  const auto row = eds::parse_ignored_check(text);
  if (!row) throw UsageError{source + ": expected CHECK or CHECK:SECTION, got \"" + eds::printable(text) + '"'};
  if (std::ranges::count(eds::kChecks, row->check, &eds::Check::id) == 0)
    throw UsageError{source + ": there is no check \"" + eds::printable(row->check) + '"'};
  return *row;
}

std::vector<eds::IgnoredCheck> ignored_checks(const LintOptions& options) {
  std::vector<eds::IgnoredCheck> checks;
  for (const std::string& text : options.ignored) checks.push_back(ignored_check(text, "--ignore"));
  if (options.ignore_list.empty()) return checks;
  std::istringstream lines{read_file(options.ignore_list)};
  unsigned number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    while (line.ends_with('\r')) line.pop_back();
    const std::string text{eds::trimmed(line.substr(0, line.find('#')))};
    if (!text.empty()) checks.push_back(ignored_check(text, options.ignore_list + ':' + std::to_string(number)));
  }
  return checks;
}

int lint(const LintOptions& options, bool as_json) {
  const std::vector<eds::IgnoredCheck> ignored = ignored_checks(options);
  json list = json::array();
  bool error = false;
  for (const std::string& file : options.files) {
    std::vector<eds::Finding> findings = eds::lint(read_file(file), file).all();
    std::erase_if(findings, [&](const eds::Finding& finding) {
      const bool beneath = options.severity == "error" && finding.severity != eds::Severity::Error;
      return beneath || eds::is_ignored(finding, ignored);
    });
    error = error || std::ranges::count(findings, eds::Severity::Error, &eds::Finding::severity) != 0;
    if (as_json) {
      for (const eds::Finding& finding : findings) list.push_back(to_json(finding));
    } else if (options.all) {
      for (const eds::Finding& finding : findings) std::cout << eds::to_text(finding) << '\n';
    } else {
      for (const eds::FindingGroup& group : eds::group_warnings(findings))
        std::cout << eds::to_text(group) << '\n';
    }
  }
  if (as_json) std::cout << list.dump() << '\n';
  return error ? kFound : kClean;
}

}  // namespace

void add_lint(CLI::App& app, Invocation& invocation) {
  CLI::App* const command = app.add_subcommand("lint", "Check files against CiA 306 and CiA 301");
  const auto options = std::make_shared<LintOptions>();
  command->add_option("files", options->files, "EDS or DCF files")->required()->type_name("FILE");
  command->add_option("--severity", options->severity, "Tell of errors only, or of warnings too (default)")
      ->check(CLI::IsMember({"error", "warning"}))
      ->type_name("error|warning");
  command
      ->add_option("--ignore", options->ignored,
                   "Do not tell of CHECK, or of CHECK in SECTION; several by commas or --ignore again")
      ->delimiter(',')
      ->type_name("CHECK[:SECTION]")
      ->allow_extra_args(false);
  command->add_option("--ignore-list", options->ignore_list, "File of what --ignore takes, one a line; # comments")
      ->type_name("FILE");
  command->add_flag("--all", options->all, "Tell of every warning, those too that say the same of the same key");
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return lint(*options, invocation.json); };
  });
}

}  // namespace edstool
