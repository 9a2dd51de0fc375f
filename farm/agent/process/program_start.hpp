#pragma once

#include <string>
#include <vector>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "os/descriptor.hpp"

namespace farm::agent {

/// A process that is known for sure: its number is not used for another one while the descriptor is held.
struct ProcessHandle {
  pid_t number = 0;
  os::Descriptor descriptor;  ///< pidfd
};

/// What a program is started with.
struct ProgramStart {
  std::vector<std::string> words;      ///< the path of the program first
  std::vector<std::string> variables;  ///< NAME=VALUE, in place of those of this process
  int output = -1;  ///< descriptor that it has as standard error; negative: that of this process
  int kept = -1;    ///< a further descriptor that it holds for its life; negative: none
};

/// Starts a program in a session of its own, with nothing of this process but standard error: it goes on when this
/// process ends. What systemd has told this process alone is not handed on. The error is one line.
[[nodiscard]] tl::expected<ProcessHandle, std::string> start_program(const ProgramStart& start);

/// The process @p number, as long as it is there.
[[nodiscard]] tl::expected<ProcessHandle, std::string> find_process(pid_t number);

/// The program @p name, which lies where this one does.
[[nodiscard]] std::string program_beside(const std::string& name);

}  // namespace farm::agent
