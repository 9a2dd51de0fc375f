#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "can/port/address.hpp"
#include "cli/usage_error.hpp"

namespace audit_tool {

/// Exit statuses.
inline constexpr int kClean = 0;       ///< no error was found
inline constexpr int kFound = 1;       ///< an error was found
inline constexpr int kUsage = 2;       ///< wrong command line, or a file that cannot be used
inline constexpr int kNotReached = 3;  ///< there was no frame, or the bus was lost

using cli::UsageError;

/// The EDS of a node.
struct Sheet {
  std::uint8_t node = 0;
  std::string path{};
};

/// What the command line asks for.
struct Options {
  std::optional<bus::Address> interface {};  ///< live
  std::string log{};                         ///< else this file
  std::string of{};                          ///< the interface that is meant in it
  std::vector<Sheet> sheets{};
  std::uint32_t bit_rate = 0;                      ///< bit/s; 0: not known
  std::optional<std::chrono::seconds> duration{};  ///< live: how long; nothing: until a signal
  std::string known{};                             ///< file; empty: nothing is known
  std::string junit{}, json{};                     ///< files to write; empty: none
  bool strict = false;                             ///< warnings are failures, too
  bool time_lines = false;                         ///< print those of the nodes
  bool list = false;                               ///< print the rules and exit
  bool markdown = false;                           ///< as the page of the docs
};

/// Reads the command line; nothing if it asked for --help or --version, which is printed then. UsageError.
[[nodiscard]] std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace audit_tool
