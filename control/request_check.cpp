#include "control/request_check.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/bounds.hpp"

namespace control {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;

/// A request under examination.
struct Examined {
  const Method& method;
  const json& params;
  std::size_t axes;
};

constexpr std::size_t kQuotedValue = 100;

/// @p value as a message shows it.
std::string shown(const json* value) {
  std::string text = value == nullptr ? "nothing" : value->dump(-1, ' ', true);
  if (text.size() > kQuotedValue) text.erase(kQuotedValue).append("...");
  return text;
}

Outcome refuse(const Parameter& parameter, std::string_view expected, const json* got) {
  return tl::unexpected{fmt::format("{}: expected {}, got {}", parameter.key, expected, shown(got))};
}

Outcome check_integer(const Parameter& parameter, const Range& range, const json* value) {
  const auto low = static_cast<std::int64_t>(range.low);
  const auto high = static_cast<std::int64_t>(range.high);
  if (value != nullptr && value->is_number_integer() && *value >= low && *value <= high) return {};
  return refuse(parameter, low == high ? whole(range.low) : fmt::format("an integer {} to {}", low, high), value);
}

Outcome check_terminal(const Parameter& parameter, const json* value) {
  if (auto outcome = check_integer(parameter, parameter.range, value); !outcome) return outcome;
  const auto number = value->get<double>();
  const bool exists = std::ranges::any_of(
      parameter.terminals, [number](const Range& range) { return range.low <= number && number <= range.high; });
  return exists ? Outcome{} : refuse(parameter, alternatives_of(parameter), value);
}

Outcome check_number(const Parameter& parameter, const Range& range, const json* value) {
  if (value != nullptr && value->is_number() && *value >= range.low && *value <= range.high) return {};
  return refuse(parameter, fmt::format("a number {} to {}", range.low, range.high), value);
}

Outcome check_choice(const Parameter& parameter, const json* value) {
  const bool fits = value != nullptr && std::ranges::any_of(parameter.choices, [value](std::string_view choice) {
                      return *value == choice;
                    });
  return fits ? Outcome{} : refuse(parameter, alternatives_of(parameter), value);
}

/// A drive object: axes by their numbers, the infeed by its name.
Outcome check_place(const Parameter& parameter, std::size_t axes, const json* value) {
  if (value != nullptr && *value == "infeed") return {};
  const bool fits = value != nullptr && value->is_number_integer() && *value >= 0 && *value <= axes;
  return fits ? Outcome{} : refuse(parameter, fmt::format("an integer 0 to {} or \"infeed\"", axes), value);
}

Outcome check_list(const Parameter& parameter, const json* value) {
  const auto is_text = [](const json& element) { return element.is_string(); };
  if (value != nullptr && value->is_string() && parameter.range.low <= 1) return {};
  if (value == nullptr || !value->is_array() || !std::ranges::all_of(*value, is_text))
    return refuse(parameter, "a text or a list of texts", value);
  const auto size = static_cast<double>(value->size());
  if (parameter.range.low <= size && size <= parameter.range.high) return {};
  return tl::unexpected{fmt::format("{}: expected {} to {} texts, got {}", parameter.key, parameter.range.low,
                                    parameter.range.high, size)};
}

/// What the texts say is for the method.
Outcome check_words(const Parameter& parameter, const json* value) {
  constexpr unsigned kHighest = 0xFFFF;
  const auto is_word = [](const json& element) {
    return element.is_string() || (element.is_number_integer() && element >= 0 && element <= kHighest);
  };
  if (value != nullptr && value->is_string()) return {};
  if (value == nullptr || !value->is_array() || !std::ranges::all_of(*value, is_word))
    return refuse(parameter, "a hexadecimal text or a list of words (0 to 65535, or hexadecimal texts)", value);
  const auto size = static_cast<double>(value->size());
  if (parameter.range.low <= size && size <= parameter.range.high) return {};
  return tl::unexpected{fmt::format("{}: expected {} to {} words, got {}", parameter.key, parameter.range.low,
                                    parameter.range.high, size)};
}

const json* value_of(const json& params, std::string_view key) {
  const auto found = params.find(key);
  return found == params.end() ? nullptr : &*found;
}

/// With what decides on its range first.
Outcome check_parameter(const Examined& request, const Parameter& parameter) {
  const json* const value = value_of(request.params, parameter.key);
  if (value == nullptr && !parameter.absent.empty()) return {};
  switch (parameter.form) {
    case Form::Axis:
      return check_integer(parameter, {parameter.range.low, static_cast<double>(request.axes)}, value);
    case Form::Place:
      return check_place(parameter, request.axes, value);
    case Form::Integer:
    case Form::Fault:
      return check_integer(parameter, parameter.range, value);
    case Form::Terminal:
      return check_terminal(parameter, value);
    case Form::Number:
      break;
    case Form::Choice:
      return check_choice(parameter, value);
    case Form::Switch:
      return value != nullptr && value->is_boolean() ? Outcome{} : refuse(parameter, "true or false", value);
    case Form::Text:
      return value != nullptr && value->is_string() ? Outcome{} : refuse(parameter, "a text", value);
    case Form::List:
      return check_list(parameter, value);
    case Form::Words:
      return check_words(parameter, value);
    case Form::Value:
    case Form::Hexadecimal: {
      const bool fits = value != nullptr && (value->is_number() || value->is_string());
      return fits ? Outcome{} : refuse(parameter, "a number or a text", value);
    }
    case Form::Any:
      return value != nullptr ? Outcome{} : refuse(parameter, "a value", value);
  }
  const Exception& exception = parameter.exception;
  if (exception.key.empty()) return check_number(parameter, parameter.range, value);
  const auto decides = std::ranges::find(request.method.parameters, exception.key, &Parameter::key);
  if (auto outcome = check_parameter(request, *decides); !outcome) return outcome;
  const json* const choice = value_of(request.params, exception.key);
  const bool is_exception = choice != nullptr && *choice == exception.choice;
  return check_number(parameter, is_exception ? exception.range : parameter.range, value);
}

}  // namespace

Outcome check(const Method& method, const json& params, std::size_t axes) {
  for (const Parameter& parameter : method.parameters)
    if (auto outcome = check_parameter({method, params, axes}, parameter); !outcome) return outcome;
  return {};
}

tl::expected<std::string, std::string> take_unit(json& params) {
  const auto unit = params.find("unit");
  if (unit == params.end()) return {};
  const json value = *unit;
  params.erase(unit);
  if (value.is_string() && !value.get_ref<const std::string&>().empty()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  return tl::unexpected{fmt::format("unit: expected a node-ID or BUS/NODE, got {}", shown(&value))};
}

}  // namespace control
