#include "control/writer/parameter_reader.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace control {
namespace {

/// A form's name in the files, and the range of one that none is given for.
struct FormRow {
  std::string_view name;
  Form form;
  Range range{};
};
constexpr double kHighestFault = 65535;
constexpr double kMostTexts = 256;
constexpr std::array kForms{
    FormRow{"axis", Form::Axis, {1, 0}},
    FormRow{"place", Form::Place},
    FormRow{"integer", Form::Integer},
    FormRow{"terminal", Form::Terminal},
    FormRow{"fault", Form::Fault, {1, kHighestFault}},
    FormRow{"number", Form::Number},
    FormRow{"choice", Form::Choice},
    FormRow{"switch", Form::Switch},
    FormRow{"text", Form::Text},
    FormRow{"list", Form::List, {1, kMostTexts}},
    FormRow{"words", Form::Words, {1, kMostTexts}},
    FormRow{"value", Form::Value},
    FormRow{"hexadecimal", Form::Hexadecimal},
    FormRow{"any", Form::Any},
};

constexpr std::array<std::string_view, 14> kParameterKeys{
    "key",    "form",   "low",     "high",     "unit",   "choices", "terminals",
    "except", "absent", "meaning", "argument", "option", "help",    "positional"};
constexpr std::array<std::string_view, 4> kExceptionKeys{"key", "choice", "low", "high"};

const FormRow& form_of(const Fields& fields) {
  const auto* const row = std::ranges::find(kForms, fields.text("form"), &FormRow::name);
  if (row != kForms.end()) return *row;
  std::string names;
  for (const FormRow& known : kForms) names.append(names.empty() ? "" : ", ").append(known.name);
  fields.refuse("form", "one of: " + names);
}

std::span<const std::string_view> choices_of(ProtocolText& text, const Fields& fields) {
  std::vector<std::string_view>& own = text.choices.emplace_back();
  for (const Json& choice : fields.list("choices")) {
    if (!choice.is_string()) fields.refuse("choices", "texts");
    own.emplace_back(choice.get_ref<const std::string&>());
  }
  return own;
}

std::span<const Range> terminals_of(ProtocolText& text, const Fields& fields) {
  std::vector<Range>& own = text.terminals.emplace_back();
  for (const Json& range : fields.list("terminals")) {
    if (!range.is_array() || range.size() != 2 || !range[0].is_number_unsigned() || !range[1].is_number_unsigned())
      fields.refuse("terminals", "pairs of numbers: [[0, 17], [20, 21]]");
    own.push_back({range[0].get<double>(), range[1].get<double>()});
  }
  return own;
}

/// The range of the row, as far as its form needs one.
void read_range(const Fields& fields, Parameter& row) {
  switch (row.form) {
    case Form::Integer:
    case Form::Number:
      row.range = {fields.number("low"), fields.number("high")};
      return;
    case Form::Terminal:
      if (row.terminals.empty()) fields.refuse("terminals", "pairs of numbers");
      row.range = {row.terminals.front().low, row.terminals.back().high};
      return;
    case Form::Axis:
      row.range.low = fields.number("low", row.range.low);
      return;
    case Form::List:
    case Form::Words:
      row.range = {fields.number("low", row.range.low), fields.number("high", row.range.high)};
      return;
    case Form::Choice:
      if (row.choices.empty()) fields.refuse("choices", "texts");
      return;
    case Form::Place:
    case Form::Fault:
    case Form::Switch:
    case Form::Text:
    case Form::Value:
    case Form::Hexadecimal:
    case Form::Any:
      return;
  }
}

/// "from_s" as a name of an option: "from-s".
std::string dashed(std::string_view key) {
  std::string name{key};
  std::ranges::replace(name, '_', '-');
  return name;
}

std::string capitals(std::string_view key) {
  std::string name{key};
  std::ranges::transform(name, name.begin(),
                         [](char c) { return 'a' <= c && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return name;
}

}  // namespace

ParameterText read_parameter(ProtocolText& text, const Json& object, const std::string& place) {
  const Fields fields{object, place, kParameterKeys};
  const FormRow& form = form_of(fields);
  Parameter row{.key = fields.text("key"), .form = form.form, .range = form.range};
  row.unit = fields.text("unit", "");
  row.choices = choices_of(text, fields);
  row.terminals = terminals_of(text, fields);
  read_range(fields, row);
  if (fields.has("except")) {
    const Fields other{fields.object("except"), fields.place("except"), kExceptionKeys};
    row.exception = {other.text("key"), other.text("choice"), {other.number("low"), other.number("high")}};
  }
  row.absent = fields.text("absent", "");
  row.argument = fields.has("argument") ? fields.text("argument") : text.names.emplace_back(capitals(row.key));
  if (!fields.flag("positional", false))
    row.option = fields.has("option") ? fields.text("option") : text.names.emplace_back(dashed(row.key));
  row.help = fields.text("help");
  return {row, fields.text("meaning", "")};
}

}  // namespace control
