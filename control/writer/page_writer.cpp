#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/bounds.hpp"
#include "control/error.hpp"
#include "control/writer/result_rows.hpp"
#include "control/writer/writers.hpp"

namespace control {
namespace {

constexpr std::string_view kBegin = "<!-- made from control/protocol/: begin -->\n";
constexpr std::string_view kEnd = "<!-- made from control/protocol/: end -->\n";

std::string text_of(const Range& range) {
  return fmt::format("{}..{}", range.low, range.high);
}

std::string number_bounds(const Parameter& parameter) {
  const Exception& exception = parameter.exception;
  if (exception.key.empty()) return text_of(parameter.range);
  return fmt::format("{}, {} if `{}` is `{}`", text_of(parameter.range), text_of(exception.range), exception.key,
                     exception.choice);
}

std::string bounds_of(const Parameter& parameter) {
  switch (parameter.form) {
    case Form::Axis:
      return parameter.range.low > 0 ? "1.." : "1.., or 0 for the control unit";
    case Form::Place:
      return "1.., 0 for the control unit, or `infeed`";
    case Form::Integer:
    case Form::Fault:
      return text_of(parameter.range);
    case Form::Number:
      return number_bounds(parameter);
    case Form::Terminal:
    case Form::Choice:
      return alternatives_of(parameter, "`");
    case Form::Switch:
      return "`true` or `false`";
    case Form::Text:
      return "text";
    case Form::List:
      return "text or list of texts";
    case Form::Words:
      return "hexadecimal text or list of words";
    case Form::Value:
      return "number or text";
    case Form::Hexadecimal:
      return "number or hexadecimal text";
    case Form::Any:
      break;
  }
  return "JSON";
}

std::string text_of(const Parameter& parameter, std::string_view meaning) {
  std::string text = fmt::format("`{}` ({}", parameter.key, bounds_of(parameter));
  text += parameter.absent.empty() ? ")" : fmt::format(", {} if absent)", parameter.absent);
  if (!meaning.empty()) text += fmt::format(": {}", meaning);
  return text;
}

std::string table_of(const Chapter& chapter) {
  std::string table = "| method | params | result |\n|---|---|---|\n";
  for (const MethodText& method : chapter.methods) {
    std::vector<std::string> cells;
    for (std::size_t n = 0; n < method.meanings.size(); ++n)
      cells.push_back(text_of(method.row.parameters[n], method.meanings[n]));
    table += fmt::format("| `{}` | {}| {} |\n", method.row.name,
                         cells.empty() ? "" : fmt::format("{} ", fmt::join(cells, "; ")), method.result_text);
  }
  return table;
}

std::string table_of(const std::vector<ResultRow>& rows) {
  std::string table = "| key | value | meaning |\n|---|---|---|\n";
  for (const ResultRow& row : rows) table += fmt::format("| `{}` | {} | {} |\n", row.key, row.type, row.meaning);
  return table;
}

std::string definitions_text(const ProtocolText& text) {
  std::string page;
  for (const auto& item : text.definitions.items()) {
    const std::vector<ResultRow> rows = rows_of(text, item.value());
    if (rows.empty()) continue;
    const bool is_choice = rows.size() == 1 && rows.front().key.empty();
    page += is_choice ? fmt::format("\n### {}\n\n{}: {}.\n", item.key(), rows.front().type, rows.front().meaning)
                      : fmt::format("\n### {}\n\n{}", item.key(), table_of(rows));
  }
  for (const auto& item : text.notices.items())
    page +=
        fmt::format("\n### Line `{{\"{0}\": {{...}}}}`\n\n{1}", item.key(), table_of(rows_of(text, item.value())));
  return page;
}

std::string errors_text() {
  std::string table = "\n## Errors\n\n| code | meaning |\n|---|---|\n";
  for (const ErrorName& row : kErrorNames) table += fmt::format("| `{}` | {} |\n", row.name, row.meaning);
  return table;
}

}  // namespace

std::string write_page(const ProtocolText& text) {
  std::string page = "## Methods\n";
  for (const Chapter& chapter : text.chapters) {
    const bool of_parameters = !chapter.methods.empty() && chapter.methods.front().row.of_parameters;
    page += fmt::format("\n### {}\n\n{}.{}\n\n{}", chapter.group, chapter.summary,
                        of_parameters ? " A device of profile cia402 refuses it." : "", table_of(chapter));
    for (const MethodText& method : chapter.methods) {
      const auto rows = method.result == nullptr ? std::vector<ResultRow>{} : rows_of(text, *method.result);
      if (!rows.empty()) page += fmt::format("\n`{}` gives\n\n{}", method.row.name, table_of(rows));
    }
  }
  const std::string definitions = definitions_text(text);
  if (!definitions.empty()) page += "\n## Values of results\n" + definitions;
  return page + errors_text();
}

std::string with_part(const std::string& page, const std::string& part) {
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw std::runtime_error{fmt::format("no lines {}... {}", kBegin, kEnd)};
  return page.substr(0, begin + kBegin.size()) + part + page.substr(end);
}

}  // namespace control
