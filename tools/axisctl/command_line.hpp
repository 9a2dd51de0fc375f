#pragma once

#include <list>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "control/method.hpp"
#include "control/words.hpp"
#include "tools/axisctl/socket_choice.hpp"

namespace axisctl {

/// What the command line asks for.
struct Invocation {
  Address address;
  std::optional<std::string> interface;
  bool json = false;
  const control::Method* method = nullptr;  ///< none: help alone was asked for
  std::vector<control::Words> words;        ///< of its parameters
};

/// The command line of the program: its options, a subcommand for each row of control::kMethods, and help.
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
  CLI::App& group_of(const control::Method& method);
  void add_commands();
  void add_help();
  void print_help() const;

  CLI::App app_{"Talks to a running axisd.", "axisctl"};
  Invocation invocation_;
  std::list<std::vector<control::Words>> words_;  // where CLI11 writes the arguments of each command to
  std::vector<std::string> help_;                 // the subcommand that help is asked for
};

}  // namespace axisctl
