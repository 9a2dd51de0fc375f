#include "tools/axisctl/command_line.hpp"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "control/methods.hpp"
#include "tools/axisctl/suggestion.hpp"

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
  const std::string meant = nearest(word, names);
  if (!meant.empty()) return fmt::format("unknown subcommand {}, did you mean {}?", word, meant);
  return fmt::format("unknown subcommand {}, expected one of: {}", word, fmt::join(names, ", "));
}

/// A word or an option of @p app for @p parameter, whose words go to @p words.
void add_argument(CLI::App& app, const control::Parameter& parameter, control::Words& words) {
  const std::string help{parameter.help};
  const bool is_word = parameter.option.empty();
  if (!is_word && parameter.form == control::Form::Switch) {
    app.add_flag_callback(
        control::argument_of(parameter), [&words] { words = {"on"}; }, help);
    return;
  }
  const std::string name = control::argument_of(parameter);
  CLI::Option* const option = parameter.form == control::Form::List
                                  ? app.add_option(name, words, help)->delimiter(is_word ? '\0' : ',')
                                  : app.add_option_function<std::string>(
                                        name, [&words](const std::string& word) { words = {word}; }, help);
  option->required(parameter.absent.empty())->type_name(is_word ? "" : std::string{parameter.argument});
}

}  // namespace

CommandLine::CommandLine() {
  add_options();
  add_commands();
  add_help();
  app_.require_subcommand(1);
}

void CommandLine::add_options() {
  app_.set_version_flag("--version", "axisctl " AXISD_VERSION);
  app_.add_option("--socket", invocation_.address.socket, "Control socket of the daemon")->type_name("PATH");
  app_.add_option("--interface", invocation_.interface,
                  "Interface of the daemon, a name or a URL as it was told; may be left out if one daemon runs")
      ->type_name("IF");
  app_.add_option("--node-id", invocation_.address.node,
                  "Node-ID of the daemon as it was told, 0 where p8620 gives it; the same")
      ->check(CLI::Range(0, kHighestNode))
      ->type_name("N");
  app_.add_flag("--json", invocation_.json, "Print the result as one line of JSON");
}

CLI::App& CommandLine::group_of(const control::Method& method) {
  const auto* const row = std::ranges::find(control::kGroups, method.group, &control::Group::name);
  if (row == control::kGroups.end()) return app_;
  const std::string name{row->name};
  const auto present = app_.get_subcommands([&name](const CLI::App* sub) { return sub->get_name() == name; });
  if (!present.empty()) return *present.front();
  CLI::App* const group = app_.add_subcommand(name, std::string{row->summary});
  group->require_subcommand(1);
  group->fallthrough();
  return *group;
}

void CommandLine::add_commands() {
  for (const control::Method& method : control::kMethods) {
    if (method.command.empty()) continue;
    CLI::App* const sub =
        group_of(method).add_subcommand(std::string{method.command}, std::string{method.summary});
    sub->fallthrough();
    std::vector<control::Words>& own = words_.emplace_back(method.parameters.size());
    for (std::size_t i = 0; i < own.size(); ++i) add_argument(*sub, method.parameters[i], own[i]);
    sub->callback([this, &method, &own] {
      invocation_.method = &method;
      invocation_.words = own;
    });
  }
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
