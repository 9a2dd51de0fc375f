
#include <fmt/format.h>

#include "text/number.hpp"
#include "tools/axisctl/command.hpp"

namespace axisctl {

tl::expected<nlohmann::json, std::string> input_parameters(Words words) {
  const auto input = text::integer<int>(words[0]);
  if (!input) return tl::unexpected{fmt::format("INPUT: expected a number from 0, got \"{}\"", words[0])};
  const bool on = words[1] == "on";
  if (!on && words[1] != "off")
    return tl::unexpected{fmt::format("STATE: expected on or off, got \"{}\"", words[1])};
  return nlohmann::json{{"input", *input}, {"state", on}};
}

}  // namespace axisctl
