#pragma once

#include <string>
#include <vector>

namespace fakes {

/// What a program left behind.
struct Finished {
  int status = -1;     ///< exit status, -1 if a signal ended it
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs @p arguments (the program first) to its end, with @p environment (NAME=VALUE) and nothing else in its
/// environment.
Finished run_program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});

}  // namespace fakes
