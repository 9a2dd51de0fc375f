#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/usage_error.hpp"
#include "farm/naming/farm_url.hpp"
#include "service/log.hpp"

namespace farm {

/// Exit statuses.
inline constexpr int kDone = 0;
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

/// What the command line asks for.
struct Options {
  FarmUrl farm;
  std::string host;                  ///< name of this host on the farm
  std::vector<std::string> sockets;  ///< of the only daemons; empty: those of the machine
  bool read_only = false;
  axisd::LogLevel log_level = axisd::LogLevel::Info;
};

using cli::UsageError;

/// Reads the command line; nothing if it asked for help or version, which then is printed. Throws UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace farm
