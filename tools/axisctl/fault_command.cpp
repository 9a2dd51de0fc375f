#include <charconv>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "tools/axisctl/command.hpp"

namespace axisctl {

namespace {

constexpr std::string_view kClassLetters = "FfAa";  // fault, alarm

/// Number that @p word means; the letter of the message class may be left out.
tl::expected<std::uint16_t, std::string> parse_fault(const std::string& word) {
  std::string_view digits{word};
  if (!digits.empty() && kClassLetters.find(digits.front()) != std::string_view::npos) digits.remove_prefix(1);
  std::uint16_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, number);
  if (error == std::errc{} && rest == end && number > 0) return number;
  return tl::unexpected{fmt::format("NUMBER: expected a number such as 7860, F07860 or A07850, got \"{}\"", word)};
}

tl::expected<std::uint32_t, std::string> parse_value(const std::string& word) {
  std::uint32_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc{} && rest == end) return value;
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
