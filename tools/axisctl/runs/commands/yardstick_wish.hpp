#pragma once

#include <string>
#include <vector>

#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/runs/fidelity/verdict.hpp"

namespace axisctl {

/// What the words of a command say of the yardstick, and of the log.
struct YardstickWish {
  std::string log{}, interface {
  }, eds{}, time{"20ms"}, deviations{};
  std::vector<std::string> bands{};
  std::optional<std::uint8_t> node{};
  std::optional<std::uint32_t> bit_rate{};
  std::size_t most = 20;  ///< differences that are shown
};

/// Adds those words to @p sub.
void add_yardstick(CLI::App& sub, YardstickWish& wish);

/// A log that can be played, and by what it is judged.
struct PlayedLog {
  runs::Yardstick yardstick{};
  std::vector<std::string> remarks{};
  std::vector<std::uint8_t> nodes{};  ///< that was named, or those that have answered in the log
};

/// Looks at the log from end to end, and tells what is to be said of it.
[[nodiscard]] Expected<PlayedLog> prepare(const YardstickWish& wish);

/// Prints @p report as a line of JSON if @p settings ask for it, else @p text.
Expected<void> print_report(const Settings& settings, const nlohmann::json& report, const std::string& text);

}  // namespace axisctl
