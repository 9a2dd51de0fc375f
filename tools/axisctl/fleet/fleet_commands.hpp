#pragma once

#include <string>
#include <vector>

#include "tools/axisctl/commands/command.hpp"

/// The subcommands of `fleet`. All need Settings::farm.
namespace fleet {

/// What `apply` is told.
struct ApplyWish {
  std::vector<std::string> files{};
  bool unchecked = false;  ///< axisd is not asked whether configurations are right
};

[[nodiscard]] axisctl::Expected<void> run_apply(const axisctl::Settings& settings, const ApplyWish& wish);
[[nodiscard]] axisctl::Expected<void> run_list(const axisctl::Settings& settings);
[[nodiscard]] axisctl::Expected<void> run_hosts(const axisctl::Settings& settings);
/// @p words: "BUS/NODE", or "BUS/*" for all units of a bus.
[[nodiscard]] axisctl::Expected<void> run_remove(const axisctl::Settings& settings,
                                                 const std::vector<std::string>& words);
[[nodiscard]] axisctl::Expected<void> run_move(const axisctl::Settings& settings, const std::string& unit,
                                               const std::string& host);
[[nodiscard]] axisctl::Expected<void> run_drain(const axisctl::Settings& settings, const std::string& host,
                                                bool drain);
/// What @p unit has saved, to @p file or from it.
[[nodiscard]] axisctl::Expected<void> run_export(const axisctl::Settings& settings, const std::string& unit,
                                                 const std::string& file);
[[nodiscard]] axisctl::Expected<void> run_import(const axisctl::Settings& settings, const std::string& unit,
                                                 const std::string& file);

}  // namespace fleet
