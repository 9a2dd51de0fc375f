// What surrounds the drive: load, line and encoder.
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "text/number.hpp"
#include "tools/axisctl/command.hpp"

namespace axisctl {

namespace {

/// The number that @p word means, an argument called @p name of @p what.
tl::expected<double, std::string> parse_number(std::string_view name, std::string_view what,
                                               const std::string& word) {
  const auto number = text::real(std::string_view{word}.substr(word.starts_with('+') ? 1 : 0));
  if (number && std::isfinite(*number)) return *number;
  return tl::unexpected{fmt::format("{}: expected a number of {}, got \"{}\"", name, what, word)};
}

}  // namespace

tl::expected<nlohmann::json, std::string> load_parameters(Words words) {
  const auto axis = parse_axis(words[0], 1);
  if (!axis) return tl::unexpected{axis.error()};
  const auto torque = parse_number("TORQUE", "N·m", words[1]);
  if (!torque) return tl::unexpected{torque.error()};
  nlohmann::json parameters{{"axis", *axis}, {"torque_Nm", *torque}};
  if (!words[2].empty()) parameters["type"] = words[2];
  return parameters;
}

tl::expected<nlohmann::json, std::string> supply_parameters(Words words) {
  const auto voltage = parse_number("VOLTAGE", "V", words[0]);
  if (!voltage) return tl::unexpected{voltage.error()};
  return nlohmann::json{{"line_voltage_V", *voltage}};
}

tl::expected<nlohmann::json, std::string> encoder_parameters(Words words) {
  const auto axis = parse_axis(words[0], 1);
  if (!axis) return tl::unexpected{axis.error()};
  return nlohmann::json{{"axis", *axis}, {"defect", words[1]}};
}

}  // namespace axisctl
