#include <iostream>
#include <regex>
#include <sstream>
#include <string>

#include "cli/completion.hpp"
#include "tools/with-can/command_line.hpp"

namespace {

/// The options as the help lists them: "  --bus PATH    the bus is at PATH", and more of that on lines that begin
/// with spaces; it ends with the exit statuses.
cli::Command described() {
  cli::Command program{"with-can", "runs a program with CAN sockets on a bus in user space"};
  std::istringstream lines{std::string{with_can::kHelp}};
  const std::regex pattern{"  (--[a-z-]+)(?: ([A-Z]+))?  +(.*)"};
  std::smatch parts;
  bool in_option = false;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, parts, pattern)) {
      program.options.push_back({{parts[1]}, parts[3], parts[2].matched, parts[2], cli::value_named(parts[2])});
      in_option = true;
    } else if (in_option && line.starts_with("   ")) {
      program.options.back().help += ' ' + line.substr(line.find_first_not_of(' '));
    } else {
      in_option = false;
    }
  }
  program.footer = with_can::kHelp.substr(with_can::kHelp.find("Exit status:"));
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
