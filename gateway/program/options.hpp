#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/usage_error.hpp"
#include "farm/naming/farm_url.hpp"
#include "gateway/security/authority.hpp"
#include "service/log.hpp"

namespace gateway {

/// Exit statuses.
inline constexpr int kDone = 0;
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

/// Address and port that are served unless the command line says otherwise.
inline constexpr std::string_view kDefaultListen = "127.0.0.1:8402";

/// What the command line asks for.
struct Options {
  std::vector<Authority> listen;           ///< at least one, each an IP address with a port; 0: any free one
  std::vector<std::string> allow_hosts;    ///< in lower case
  std::vector<std::string> allow_origins;  ///< in lower case: scheme://host[:port]
  std::string token_file;                  ///< empty: token_path()
  bool read_only = false;
  std::string page;                   ///< folder of the web page; empty: that beside the program
  std::vector<std::string> sockets;   ///< of the only daemons; empty: those of the machine
  std::optional<farm::FarmUrl> farm;  ///< whose units are served in place of those of the machine
  axisd::LogLevel log_level = axisd::LogLevel::Info;
};

using cli::UsageError;

/// Reads the command line; nothing if it asked for help or version, which then is printed. Throws UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace gateway
