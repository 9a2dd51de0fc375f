#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/usage_error.hpp"
#include "farm/naming/farm_url.hpp"
#include "service/log_level.hpp"

namespace farm::agent {

/// Exit statuses.
inline constexpr int kDone = 0;
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

/// What the command line asks for.
struct Options {
  FarmUrl farm;
  std::vector<std::string> security;  ///< the options of the NATS server, as hubs get them
  std::string host;
  std::uint32_t capacity = 0;  ///< units that are a fair share of this host
  std::set<std::string> buses;
  std::string runtime;  ///< folder
  std::string state;    ///< folder
  std::string control_group;
  bool drain_on_stop = false;
  axisd::LogLevel log_level = axisd::LogLevel::Info;
  std::string log_level_name;
};

using cli::UsageError;

/// Reads the command line; nothing if it asked for help or version, which then is printed. Throws UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace farm::agent
