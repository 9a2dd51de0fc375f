#include "tools/edstool/command.hpp"

#include <array>
#include <fstream>
#include <iostream>

#include "tools/sheet_file.hpp"

namespace edstool {
namespace {

constexpr std::array<AddCommand, 6> kCommands{add_lint, add_show, add_diff, add_flatten, add_dcf, add_source};

void write_file(const std::string& path, const std::string& text) {
  std::ofstream stream{path, std::ios::binary};
  stream << text;
  stream.close();
  if (!stream) throw UsageError{path + ": cannot be written"};
}

}  // namespace

std::span<const AddCommand> commands() noexcept {
  return kCommands;
}

std::string read_file(const std::string& path) {
  auto text = tools::read_sheet_file(path);
  if (!text) throw UsageError{text.error()};
  return *std::move(text);
}

InputFile::InputFile(const std::string& path_given)
    : path{path_given},
      findings{path_given},
      document{eds::read_document(read_file(path_given), findings)},
      sheet{eds::read_data_sheet(document, findings)} {
  if (document.sections().size() == 1)  // what stands before the first one
    throw UsageError{path + ": expected an EDS or DCF, found no section in it"};
}

nlohmann::json to_json(const eds::Finding& finding) {
  return {{"file", eds::printable(finding.file)},
          {"line", finding.line},
          {"severity", finding.severity == eds::Severity::Error ? "error" : "warning"},
          {"check", finding.check},
          {"section", finding.section},
          {"key", finding.key},
          {"expected", eds::printable(finding.expected)},
          {"found", finding.found}};
}

int deliver(const Made& made, bool json) {
  const bool complete = !made.findings.has_error();
  const std::vector<eds::Finding>& findings = made.findings.all();
  if (complete && !made.output.empty()) write_file(made.output, made.text);
  if (json) {
    nlohmann::json result{{"findings", nlohmann::json::array()}};
    for (const eds::Finding& finding : findings) result["findings"].push_back(to_json(finding));
    if (complete && made.output.empty()) result["text"] = made.text;
    std::cout << result.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  } else {
    for (const eds::Finding& finding : findings) std::cerr << eds::to_text(finding) << '\n';
    if (complete && made.output.empty()) std::cout << made.text;
  }
  return complete ? kClean : kFound;
}

}  // namespace edstool
