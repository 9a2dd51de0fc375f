#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "text/number.hpp"
#include "tools/axisctl/command.hpp"

namespace axisctl {

namespace {

constexpr std::string_view kClassLetters = "FfAa";  // fault, alarm

/// Number that @p word means; the letter of the message class may be left out.
tl::expected<std::uint16_t, std::string> parse_fault(const std::string& word) {
  std::string_view digits{word};
  if (!digits.empty() && kClassLetters.find(digits.front()) != std::string_view::npos) digits.remove_prefix(1);
  const auto number = text::integer<std::uint16_t>(digits);
  if (number && *number > 0) return *number;
  return tl::unexpected{fmt::format("NUMBER: expected a number such as 7860, F07860 or A07850, got \"{}\"", word)};
}

tl::expected<std::uint32_t, std::string> parse_value(const std::string& word) {
  if (const auto value = text::integer<std::uint32_t>(word)) return *value;
  return tl::unexpected{fmt::format("VALUE: expected a number 0 to 4294967295, got \"{}\"", word)};
}

}  // namespace

tl::expected<nlohmann::json, std::string> fault_inject_parameters(Words words) {
  const auto axis = parse_axis(words[0], kControlUnit);
  if (!axis) return tl::unexpected{axis.error()};
  const auto number = parse_fault(words[1]);
  if (!number) return tl::unexpected{number.error()};
  nlohmann::json parameters{{"axis", *axis}, {"number", *number}};
  if (words[2].empty()) return parameters;
  const auto value = parse_value(words[2]);
  if (!value) return tl::unexpected{value.error()};
  parameters["value"] = *value;
  return parameters;
}

tl::expected<nlohmann::json, std::string> fault_ack_parameters(Words words) {
  const auto axis = parse_axis(words[0], kControlUnit);
  if (!axis) return tl::unexpected{axis.error()};
  return nlohmann::json{{"axis", *axis}};
}

}  // namespace axisctl
