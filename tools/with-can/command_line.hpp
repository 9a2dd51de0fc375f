#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace with_can {

/// What the command line asks for.
struct CommandLine {
  bool help = false;
  bool version = false;
  bool own_bus = false;              ///< a new bus, which nobody else knows yet
  std::string bus;                   ///< path of the bus; empty: the default
  std::uint32_t bit_rate = 0;        ///< bit/s; 0: as the bus is
  std::span<char* const> command{};  ///< the program and its arguments, as execvp(3) takes them but for the end
};

/// Lowest and highest bit rate (bit/s).
inline constexpr std::uint32_t kLowestBitRate = 10'000;
inline constexpr std::uint32_t kHighestBitRate = 1'000'000;

/// Reads the words behind the program's name. What comes from the first word on that is no option of ours, or
/// behind "--", is the command. The error is one line.
tl::expected<CommandLine, std::string> read_command_line(std::span<char* const> words);

/// What --help prints.
extern const std::string_view kHelp;

}  // namespace with_can
