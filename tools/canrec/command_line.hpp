#pragma once

#include <string>

#include "cli/usage_error.hpp"
#include "tools/canrec/commands/command.hpp"

namespace canrec {

using cli::UsageError;

/// What the command line asks for.
struct Invocation {
  Run run;  ///< nothing: help, version or a completion was asked for and has been printed
  nats::ServerOptions server;
};

/// Reads the command line. UsageError.
[[nodiscard]] Invocation parse_command_line(int count, const char* const* words);

}  // namespace canrec
