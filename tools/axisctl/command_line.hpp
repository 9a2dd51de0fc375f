#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "control/method.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/farm_option.hpp"

namespace axisctl {

/// What the command line asks for.
struct Invocation {
  Settings settings{};
  FarmOption farm{};
  std::optional<std::string> interface {};
  std::optional<std::string> unit{};
  bool brief = false;
  Run run{};  ///< none: help alone was asked for
};

/// The command line of the program: its options, a subcommand for each row of control::kMethods that has one,
/// those that are more than a row, and help.
class CommandLine {
 public:
  CommandLine();

  /// Reads the arguments of main(); throws CLI::ParseError, for help and version too.
  void parse(int argc, const char* const* argv) { app_.parse(argc, argv); }
  /// Prints what @p thrown, which parse() has thrown, says on its success; its exit status.
  int exit(const CLI::ParseError& thrown) const { return app_.exit(thrown); }
  /// In one line what @p thrown complains of.
  std::string complaint(const CLI::ParseError& thrown) const;

  Invocation& invocation() noexcept { return invocation_; }

 private:
  void add_options();
  void add_help();
  void print_help() const;

  CLI::App app_{"Talks to a running axisd.", "axisctl"};
  Invocation invocation_;
  std::vector<std::string> help_;  // the subcommand that help is asked for
};

}  // namespace axisctl
