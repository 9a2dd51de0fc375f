#include "tools/axisctl/command_line.hpp"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "cli/suggestion.hpp"
#include "tools/axisctl/completion.hpp"
#include "version/version.hpp"

namespace axisctl {
namespace {

constexpr int kHighestNode = 127;

std::vector<std::string> names_below(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const sub : app.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

/// In one line: @p word is no subcommand of @p app.
std::string unknown_subcommand(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> names = names_below(app);
  const std::string meant = cli::nearest(word, names);
  if (!meant.empty()) return fmt::format("unknown subcommand {}, did you mean {}?", word, meant);
  return fmt::format("unknown subcommand {}, expected one of: {}", word, fmt::join(names, ", "));
}

}  // namespace

CommandLine::CommandLine() {
  add_options();
  add_methods(app_, invocation_.run);
  for (const AddCommand add : commands()) add(app_, invocation_.run);
  add_help();
  cli::add_completion(app_, add_choices);
  app_.require_subcommand(1);
}

void CommandLine::add_options() {
  Address& address = invocation_.settings.address;
  app_.set_version_flag("--version", version::line("axisctl"));
  app_.add_option("--unit", invocation_.unit,
                  "Unit: node-ID as it was told to the daemon, or BUS/NODE; may be left out if there is one")
      ->type_name("UNIT");
  app_.add_option("--socket", address.socket, "Control socket of the daemon")->type_name("PATH");
  app_.add_option("--interface", invocation_.interface,
                  "Interface of the unit, a name or a URL as it was told; may be left out if there is one")
      ->type_name("IF");
  app_.add_option("--node-id", address.node,
                  "Node-ID of the unit as it was told, 0 where p8620 gives it, 255 where LSS does; the same")
      ->check(CLI::Range(0, kHighestNode) | CLI::IsMember({std::string{kAnyUnconfigured}}))
      ->type_name("N");
  add_farm_options(app_, invocation_.farm);
  app_.add_flag("--json", invocation_.settings.json, "Print the result as one line of JSON");
  app_.add_flag("-b,--brief", invocation_.brief, "Print one line an axis or thing, without heads");
  std::vector<cli::ExitRow> rows;
  for (const ExitRow& row : kExitRows) rows.push_back({static_cast<int>(row.status), row.meaning});
  app_.footer(cli::exit_footer(rows));
}

void CommandLine::add_help() {
  CLI::App* const sub = app_.add_subcommand("help", "Print this help, or that of a subcommand");
  sub->fallthrough();
  sub->add_option("SUBCOMMAND", help_, "Subcommand, all if not given")->type_name("");
  sub->callback([this] { print_help(); });
}

void CommandLine::print_help() const {
  const CLI::App* app = &app_;
  std::string before;
  for (const std::string& word : help_) {
    const std::vector<const CLI::App*> below = app->get_subcommands({});
    const auto found = std::ranges::find(below, word, [](const CLI::App* sub) { return sub->get_name(); });
    if (found == below.end()) throw CLI::ValidationError{unknown_subcommand(*app, word)};
    before += (before.empty() ? "" : " ") + app->get_name();
    app = *found;
  }
  const std::string name = before.empty() ? app->get_name() : before + ' ' + app->get_name();
  std::cout << app->get_formatter()->make_help(app, name, CLI::AppFormatMode::Normal);
}

std::string CommandLine::complaint(const CLI::ParseError& thrown) const {
  const auto* const missing = dynamic_cast<const CLI::RequiredError*>(&thrown);
  const CLI::App* asked = &app_;
  while (!asked->get_subcommands().empty()) asked = asked->get_subcommands().front();
  const bool needs_subcommand = !asked->get_subcommands({}).empty();
  if (missing == nullptr || !needs_subcommand) return thrown.what();
  const std::vector<std::string> rest = app_.remaining(true);
  if (rest.empty())
    return fmt::format("expected a subcommand: {}; see {} --help", fmt::join(names_below(*asked), ", "),
                       app_.get_name());
  if (rest.front().starts_with('-')) return fmt::format("unknown option {}", rest.front());
  return unknown_subcommand(*asked, rest.front());
}

}  // namespace axisctl
