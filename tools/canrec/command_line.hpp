#pragma once

#include <stdexcept>
#include <string>

#include "tools/canrec/commands/command.hpp"

namespace canrec {

/// What is wrong with the command line, in one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the command line asks for.
struct Invocation {
  Run run;  ///< nothing: help, version or a completion was asked for and has been printed
  nats::ServerOptions server;
};

/// Reads the command line. UsageError.
[[nodiscard]] Invocation parse_command_line(int count, const char* const* words);

}  // namespace canrec
