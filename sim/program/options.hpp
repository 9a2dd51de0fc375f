#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/usage_error.hpp"
#include "service/log_level.hpp"

namespace sim {

/// Exit statuses.
inline constexpr int kHolds = 0;   ///< every invariant held
inline constexpr int kBroken = 1;  ///< one did not
inline constexpr int kUsage = 2;   ///< wrong command line, or a file that cannot be used

using cli::UsageError;

/// What the command line asks for.
struct Options {
  std::uint64_t first = 1;  ///< seed
  std::uint64_t seeds = 1;  ///< how many
  std::string plan;         ///< file; empty: plans are drawn
  std::string json;         ///< file to write; empty: none
  std::string log;          ///< file for all frames; empty: none
  bool shrinks = false;     ///< a plan that fails
  bool prints_plan = false;
  bool lists = false;
  bool repeats = false;  ///< each world twice, which have to be alike
  std::optional<axisd::LogLevel> log_level{};
};

/// Reads the command line; nothing if it asked for --help or --version, which is printed then. UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace sim
