#include "control/words.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/bounds.hpp"
#include "json/strict.hpp"

namespace control {
namespace {

using nlohmann::json;

constexpr std::string_view kClassLetters = "FfAa";  // fault, alarm

/// The whole of @p digits as a number; nothing if it is none.
template <class Number>
std::optional<Number> number_of(std::string_view digits) {
  Number number{};
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, number);
  return error == std::errc{} && rest == end ? std::optional{number} : std::nullopt;
}

/// A word's value and what was expected where it has none.
struct Reading {
  std::optional<json> value;
  std::string expected;
};

template <class Number>
Reading reading_of(std::optional<Number> number, const Range& range, std::string expected) {
  const bool fits =
      number && static_cast<double>(*number) >= range.low && static_cast<double>(*number) <= range.high;
  return {fits ? std::optional<json>{*number} : std::nullopt, std::move(expected)};
}

/// An axis or a terminal; the unit decides which of them there are.
Reading read_place(const Parameter& parameter, std::string_view word) {
  const auto number = number_of<int>(word);
  const bool is_below = number && parameter.form == Form::Axis && *number < parameter.range.low;
  return {number && !is_below ? std::optional<json>{*number} : std::nullopt,
          fmt::format("a number from {}", whole(parameter.range.low))};
}

/// The number of a drive object, or the infeed's name.
Reading read_drive_object(std::string_view word) {
  constexpr std::string_view kExpected = "a number from 0 or infeed";
  if (word == "infeed") return {word, ""};
  const auto number = number_of<std::uint32_t>(word);
  return {number ? std::optional<json>{*number} : std::nullopt, std::string{kExpected}};
}

/// A number as such: "0.5", "-3", "0x1A"; else the text.
json read_value(std::string_view word) {
  constexpr std::string_view kHexadecimal = "0x";
  constexpr int kBase = 16;
  const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
  if (const auto whole = number_of<std::int64_t>(digits)) return *whole;
  if (const auto number = number_of<double>(digits); number && std::isfinite(*number)) return *number;
  if (!word.starts_with(kHexadecimal)) return word;
  std::uint64_t bits = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data() + kHexadecimal.size(), end, bits, kBase);
  return error == std::errc{} && rest == end ? json(bits) : json(word);
}

/// The letter of the message class may be left out.
Reading read_fault(const Parameter& parameter, std::string_view word) {
  if (!word.empty() && kClassLetters.find(word.front()) != std::string_view::npos) word.remove_prefix(1);
  return reading_of(number_of<std::uint16_t>(word), parameter.range, "a number such as 7860, F07860 or A07850");
}

Reading read_number(const Parameter& parameter, std::string_view word) {
  const auto number = number_of<double>(word.substr(word.starts_with('+') ? 1 : 0));
  return {number && std::isfinite(*number) ? std::optional<json>{*number} : std::nullopt,
          parameter.unit.empty() ? "a number" : fmt::format("a number of {}", parameter.unit)};
}

Reading read_switch(std::string_view word) {
  const bool on = word == "on";
  return {on || word == "off" ? std::optional<json>{on} : std::nullopt, "on or off"};
}

Reading read_word(const Parameter& parameter, const std::string& word) {
  switch (parameter.form) {
    case Form::Place:
      return read_drive_object(word);
    case Form::Axis:
    case Form::Terminal:
      return read_place(parameter, word);
    case Form::Integer:
      return reading_of(number_of<std::uint32_t>(word), parameter.range,
                        fmt::format("a number {} to {}", whole(parameter.range.low), whole(parameter.range.high)));
    case Form::Fault:
      return read_fault(parameter, word);
    case Form::Number:
      return read_number(parameter, word);
    case Form::Choice:  // the daemon knows them
    case Form::Text:
    case Form::List:
    case Form::Words:
    case Form::Hexadecimal:
      return {word, ""};
    case Form::Switch:
      return read_switch(word);
    case Form::Value:
      return {read_value(word), ""};
    case Form::Any:
      break;
  }
  json value = json::parse(word, nullptr, /*allow_exceptions=*/false);
  return {value.is_discarded() ? json(word) : std::move(value), ""};
}

}  // namespace

std::string argument_of(const Parameter& parameter) {
  return parameter.option.empty() ? std::string{parameter.argument} : "--" + std::string{parameter.option};
}

tl::expected<json, std::string> parse_words(const Method& method, std::span<const Words> words) {
  json params = json::object();
  for (std::size_t i = 0; i < method.parameters.size(); ++i) {
    const Parameter& parameter = method.parameters[i];
    if (words[i].empty()) continue;
    json& value = params[std::string{parameter.key}];
    if (parameter.form == Form::List || parameter.form == Form::Words) {
      value = words[i];
      continue;
    }
    Reading reading = read_word(parameter, words[i].front());
    if (!reading.value)
      return tl::unexpected{fmt::format("{}: expected {}, got {}", argument_of(parameter), reading.expected,
                                        json_text::quote(words[i].front()))};
    value = *std::move(reading.value);
  }
  return params;
}

std::string in_words_of(const Method& method, const std::string& message) {
  for (const Parameter& parameter : method.parameters)
    if (message.starts_with(std::string{parameter.key} + ": "))
      return argument_of(parameter) + message.substr(parameter.key.size());
  return message;
}

}  // namespace control
