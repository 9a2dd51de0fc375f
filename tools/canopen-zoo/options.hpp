#pragma once

#include <optional>
#include <string>

#include "can/port/address.hpp"
#include "cli/usage_error.hpp"
#include "tools/canopen-zoo/list.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {

// Exit statuses.
inline constexpr int kDone = 0;    ///< listed or written, or ended by a signal
inline constexpr int kFailed = 1;  ///< the bus cannot be used
inline constexpr int kUsage = 2;   ///< wrong command line, or a file that cannot be written

using cli::UsageError;

/// What the command line asks for.
struct Options {
  std::optional<ListForm> list{};            ///< print the slaves and exit
  WrongSlave slave{};                        ///< else this one
  std::string eds{};                         ///< file for its EDS, "-" for standard output; empty: none
  std::optional<bus::Address> interface {};  ///< none: the EDS alone
  std::uint8_t node_id = 0;                  ///< 1..127 if there is an interface
};

/// Reads the command line; nothing if it asked for --help or --version, which is printed then. UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace zoo
