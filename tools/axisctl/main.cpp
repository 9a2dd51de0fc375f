#include <exception>
#include <iostream>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bus/address.hpp"
#include "tools/axisctl/client.hpp"
#include "tools/axisctl/command.hpp"
#include "tools/axisctl/socket_choice.hpp"

namespace {

using axisctl::Command;

constexpr int kSuccess = 0;
constexpr int kFailure = 1;
constexpr int kUsage = 2;
constexpr int kHighestNode = 127;

/// What the command line asks for.
struct Invocation {
  axisctl::Address address;
  std::optional<std::string> interface;
  bool json = false;
  const Command* command = nullptr;
  std::vector<std::string> words;
};

void add_options(CLI::App& app, Invocation& invocation) {
  app.set_version_flag("--version", "axisctl " AXISD_VERSION);
  app.add_option("--socket", invocation.address.socket, "Control socket of the daemon")->type_name("PATH");
  app.add_option("--interface", invocation.interface,
                 "Interface of the daemon, a name or a URL as it was told (default vcan0)")
      ->type_name("IF");
  app.add_option("--node-id", invocation.address.node,
                 "Node-ID of the daemon as it was told, 0 where p8620 gives it (default 2)")
      ->check(CLI::Range(0, kHighestNode))
      ->type_name("N");
  app.add_flag("--json", invocation.json, "Print the result as one line of JSON");
}

CLI::App& group_of(CLI::App& app, const Command& command) {
  if (command.group.empty()) return app;
  const std::string name{command.group};
  const auto present = app.get_subcommands([&name](const CLI::App* sub) { return sub->get_name() == name; });
  if (!present.empty()) return *present.front();
  CLI::App* const group = app.add_subcommand(name, "Inject or acknowledge faults");
  group->require_subcommand(1);
  group->fallthrough();
  return *group;
}

/// One CLI11 subcommand for each row of the table; @p words keeps the places CLI11 writes to.
void add_commands(CLI::App& app, Invocation& invocation, std::list<std::vector<std::string>>& words) {
  for (const Command& command : axisctl::commands()) {
    CLI::App* const sub =
        group_of(app, command).add_subcommand(std::string{command.name}, std::string{command.summary});
    sub->fallthrough();
    std::vector<std::string>& own = words.emplace_back(command.arguments.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      sub->add_option(std::string{command.arguments[i].name}, own[i], std::string{command.arguments[i].summary})
          ->required(!command.arguments[i].optional)
          ->type_name("");
    sub->callback([&invocation, &command, &own] {
      invocation.command = &command;
      invocation.words = own;
    });
  }
}

int usage_error(const std::string& message) {
  std::cerr << "axisctl: " << message << '\n';
  return kUsage;
}

int run(Invocation& invocation) {
  const Command& command = *invocation.command;
  const auto parameters = command.parameters(invocation.words);
  if (!parameters) return usage_error(parameters.error());
  if (invocation.interface) {
    const auto address = bus::parse_address(*invocation.interface);
    if (!address)
      return usage_error("--interface: expected " + address.error() + ", got \"" + *invocation.interface + '"');
    invocation.address.label = bus::label(*address);
  }
  const auto path = axisctl::choose_socket(invocation.address);
  if (!path) {
    std::string message = "several daemons run; choose one with --socket, or --interface and --node-id:";
    for (const std::string& candidate : path.error()) message += "\n  " + candidate;
    return usage_error(message);
  }
  const auto result = axisctl::ask(*path, {command.method, *parameters});
  if (!result) {
    std::cerr << "axisctl: " << result.error() << '\n';
    return kFailure;
  }
  if (invocation.json)
    std::cout << *result << '\n';
  else
    command.print(std::cout, *result);
  std::cout.flush();
  return std::cout ? kSuccess : kFailure;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Talks to a running axisd.", "axisctl"};
  Invocation invocation;
  std::list<std::vector<std::string>> words;
  add_options(app, invocation);
  add_commands(app, invocation, words);
  app.require_subcommand(1);
  try {
    app.parse(argc, argv);
    return run(invocation);
  } catch (const CLI::ParseError& error) {
    // Help and version are thrown too.
    return error.get_exit_code() == 0 ? app.exit(error) : usage_error(error.what());
  } catch (const std::exception& error) {
    std::cerr << "axisctl: " << error.what() << '\n';
    return kFailure;
  }
}
