#pragma once

#include <optional>
#include <string>
#include <vector>

#include "can/port/address.hpp"
#include "cli/usage_error.hpp"
#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// Exit statuses.
inline constexpr int kClean = 0;       ///< no check failed
inline constexpr int kFound = 1;       ///< a check failed, or could not be ended
inline constexpr int kUsage = 2;       ///< wrong command line, or a file that cannot be used
inline constexpr int kNotReached = 3;  ///< nothing was tested

using cli::UsageError;

/// What the command line asks for.
struct Options {
  std::optional<bus::Address> interface {};
  std::vector<std::string> eds_files{};
  std::vector<std::string> only{};  ///< groups, or beginnings of ids; none: everything
  std::string deviations{};         ///< file; empty: no deviation is known
  std::string junit{}, json{};      ///< files to write; empty: none
  bool list = false;                ///< print the checks and exit
  bool markdown = false;            ///< as rows of a table of Markdown
  bool verbose = false;
  Settings settings{};
};

/// Reads the command line; nothing if it asked for --help or --version, which is printed then. UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

/// True if @p options ask for @p check.
[[nodiscard]] bool is_wanted(const Options& options, const Check& check);

}  // namespace conformance
