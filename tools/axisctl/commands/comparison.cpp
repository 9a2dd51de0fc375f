#include "tools/axisctl/commands/comparison.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <string_view>

#include <fmt/format.h>

namespace axisctl {
namespace {

using nlohmann::json;

struct Operator {
  std::string_view word;
  std::string_view sign;
  bool (*compare)(double left, double right);
};
constexpr std::array kOperators{
    Operator{"lt", "<", [](double a, double b) { return a < b; }},
    Operator{"le", "<=", [](double a, double b) { return a <= b; }},
    Operator{"eq", "==", [](double a, double b) { return std::equal_to{}(a, b); }},
    Operator{"ne", "!=", [](double a, double b) { return std::not_equal_to{}(a, b); }},
    Operator{"ge", ">=", [](double a, double b) { return a >= b; }},
    Operator{"gt", ">", [](double a, double b) { return a > b; }},
};

}  // namespace

Expected<Comparison> parse_comparison(const std::string& word, const std::string& number) {
  const auto* const row = std::ranges::find_if(
      kOperators, [&word](const Operator& known) { return word == known.word || word == known.sign; });
  if (row == kOperators.end())
    return fail(ExitStatus::Usage, fmt::format("COMPARISON: expected lt, le, eq, ne, ge or gt, got \"{}\"", word));
  Comparison comparison{row->compare};
  const char* const end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data(), end, comparison.right);
  if (error != std::errc{} || rest != end)
    return fail(ExitStatus::Usage, fmt::format("VALUE: expected a number, got \"{}\"", number));
  return comparison;
}

Expected<double> read_signal(Session& session, const std::string& signal) {
  const auto result = session.ask("signal.read", {{"signals", json::array({signal})}});
  if (!result) return tl::unexpected{result.error()};
  const json value = result->is_object() ? result->value("/signals/0/value"_json_pointer, json{}) : json{};
  if (value.is_number()) return value.get<double>();
  return fail(ExitStatus::NotUnderstood, fmt::format("SIGNAL: {} has no value", signal));
}

}  // namespace axisctl
