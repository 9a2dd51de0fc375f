#include <charconv>

#include <fmt/format.h>

#include "tools/axisctl/command.hpp"

namespace axisctl {

tl::expected<nlohmann::json, std::string> input_parameters(Words words) {
  int input = 0;
  const char* const end = words[0].data() + words[0].size();
  const auto [rest, error] = std::from_chars(words[0].data(), end, input);
  if (error != std::errc{} || rest != end)
    return tl::unexpected{fmt::format("INPUT: expected a number from 0, got \"{}\"", words[0])};
  const bool on = words[1] == "on";
  if (!on && words[1] != "off")
    return tl::unexpected{fmt::format("STATE: expected on or off, got \"{}\"", words[1])};
  return nlohmann::json{{"input", input}, {"state", on}};
}

}  // namespace axisctl
