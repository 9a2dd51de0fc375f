#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "tools/axisctl/command.hpp"

namespace axisctl {

namespace {

tl::expected<double, std::string> parse_torque(const std::string& word) {
  double torque = 0.0;
  const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(begin, end, torque);
  if (error == std::errc{} && rest == end && std::isfinite(torque)) return torque;
  return tl::unexpected{fmt::format("TORQUE: expected a number of N·m, got \"{}\"", word)};
}

}  // namespace

tl::expected<nlohmann::json, std::string> load_parameters(Words words) {
  const auto axis = parse_axis(words[0], 1);
  if (!axis) return tl::unexpected{axis.error()};
  const auto torque = parse_torque(words[1]);
  if (!torque) return tl::unexpected{torque.error()};
  return nlohmann::json{{"axis", *axis}, {"torque_Nm", *torque}};
}

}  // namespace axisctl
