#pragma once

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
  std::string bit_rate;              ///< digits, bit/s, "0": frames take no time; empty: as the bus is
  std::string time;                  ///< as userbus::read_time() takes it; empty: $CAN_TIME
  std::span<char* const> command{};  ///< the program and its arguments, as execvp(3) takes them but for the end
};

/// Reads the words behind the program's name. What comes from the first word on that is no option of ours, or
/// behind "--", is the command. The error is one line.
tl::expected<CommandLine, std::string> read_command_line(std::span<char* const> words);

/// What --help prints.
extern const std::string_view kHelp;

}  // namespace with_can
