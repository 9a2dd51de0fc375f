#include "control/page.hpp"

#include <vector>

#include <fmt/format.h>

#include "control/bounds.hpp"
#include "control/methods.hpp"

namespace control {
namespace {

std::string text_of(const Range& range) {
  return fmt::format("{}..{}", whole(range.low), whole(range.high));
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
    case Form::Integer:
    case Form::Fault:
      return text_of(parameter.range);
    case Form::Number:
      return number_bounds(parameter);
    case Form::Terminal:
    case Form::Choice:
      return alternatives_of(parameter, "`");
    case Form::Switch:
      break;
  }
  return "`true` or `false`";
}

std::string text_of(const Parameter& parameter) {
  std::string text = fmt::format("`{}` ({}", parameter.key, bounds_of(parameter));
  text += parameter.absent.empty() ? ")" : fmt::format(", {} if absent)", parameter.absent);
  if (!parameter.meaning.empty()) text += fmt::format(": {}", parameter.meaning);
  return text;
}

}  // namespace

std::string method_table() {
  std::string table = "| method | params | result |\n|---|---|---|\n";
  for (const Method& method : kMethods) {
    std::vector<std::string> cells;
    for (const Parameter& parameter : method.parameters) cells.push_back(text_of(parameter));
    table += fmt::format("| `{}` | {}| {} |\n", method.name,
                         cells.empty() ? "" : fmt::format("{} ", fmt::join(cells, "; ")), method.result);
  }
  return table;
}

}  // namespace control
