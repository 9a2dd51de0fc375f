#include <iostream>
#include <regex>
#include <sstream>
#include <string>

#include "cli/completion.hpp"
#include "tools/with-can/command_line.hpp"

namespace {

/// The options as the help lists them: "  --bus PATH    the bus is at PATH".
cli::Command described() {
  cli::Command program{"with-can", "runs a program with CAN sockets on a bus in user space"};
  std::istringstream lines{std::string{with_can::kHelp}};
  const std::regex pattern{"  (--[a-z-]+)(?: ([A-Z]+))?  +(.*)"};
  std::smatch parts;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, parts, pattern))
      program.options.push_back({{parts[1]}, parts[3], parts[2].matched, parts[2], cli::value_named(parts[2])});
  program.words.push_back({"COMMAND", "program and its arguments", true, true, {cli::Kind::Command}});
  return program;
}

}  // namespace

/// Called as the programs themselves are: --completion SHELL.
int main(int count, char** words) {
  const std::string script = count == 3 ? cli::completion_script(described(), words[2]) : "";
  std::cout << script;
  return script.empty() ? 2 : 0;
}
