#pragma once

#include <optional>
#include <string>

#include "cli/usage_error.hpp"
#include "daemon/configuration/settings/profile.hpp"
#include "service/log.hpp"

namespace axisd {

/// Exit statuses.
inline constexpr int kDone = 0;
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

/// The command line, as given; what is absent is decided by the configuration file or its defaults.
struct Options {
  std::string config_file;
  std::optional<std::string> interface;
  std::optional<std::string> bus;
  std::optional<Profile> profile;
  std::optional<int> node_id;
  std::optional<int> axes;
  std::string state_directory;
  std::string control;        ///< path of the control socket; empty = default, "none" = off
  std::string control_group;  ///< whose members may use it; empty = that of the configuration
  bool check_config = false;
  LogLevel log_level = LogLevel::Info;
};

using cli::UsageError;

/// Parses the command line. Gives nothing if the answer was printed already (--help, --version); throws
/// UsageError.
std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace axisd
