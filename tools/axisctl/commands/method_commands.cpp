#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "control/methods.hpp"
#include "control/words.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/connection/whole_answer.hpp"
#include "tools/axisctl/print/printable.hpp"

namespace axisctl {
namespace {

using nlohmann::json;
using AllWords = std::vector<control::Words>;

constexpr std::string_view kRecordedThere = "the files are written on the host of the unit";

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
  CLI::Option* const option = parameter.form == control::Form::List || parameter.form == control::Form::Words
                                  ? app.add_option(name, words, help)->delimiter(is_word ? '\0' : ',')
                                  : app.add_option_function<std::string>(
                                        name, [&words](const std::string& word) { words = {word}; }, help);
  option->required(parameter.absent.empty())->type_name(is_word ? "" : std::string{parameter.argument});
}

CLI::App& group_of(CLI::App& app, const control::Method& method) {
  const auto* const row = std::ranges::find(control::kGroups, method.group, &control::Group::name);
  if (row == control::kGroups.end()) return app;
  CLI::App& group = subcommand(app, row->name, row->summary);
  group.require_subcommand(1);
  return group;
}

Expected<void> run_method(const control::Method& method, const AllWords& words, const Settings& settings) {
  if (method.group == "record")
    if (auto done = expect_no_farm(settings, "record " + std::string{method.command}, kRecordedThere); !done)
      return done;
  const auto params = control::parse_words(method, words);
  if (!params) return fail(ExitStatus::Usage, params.error());
  auto session = Session::open(settings);
  if (!session) return tl::unexpected{session.error()};
  const Ask ask = [&session](std::string_view name, json given) { return session->ask(name, std::move(given)); };
  auto result = ask_whole(ask, method.name, *params);
  if (!result) {
    result.error().message = control::in_words_of(method, result.error().message);
    return tl::unexpected{result.error()};
  }
  if (settings.json)
    std::cout << printable(result->dump()) << '\n';
  else
    print_result(std::cout, method, printable_values(*result), settings.style);
  return {};
}

}  // namespace

void add_methods(CLI::App& app, Run& run) {
  for (const control::Method& method : control::kMethods) {
    if (method.command.empty()) continue;
    CLI::App& sub = subcommand(group_of(app, method), method.command, method.summary);
    const auto words = std::make_shared<AllWords>(method.parameters.size());
    for (std::size_t i = 0; i < words->size(); ++i) add_argument(sub, method.parameters[i], (*words)[i]);
    sub.callback([&run, &method, words] {
      run = [&method, words](const Settings& settings) { return run_method(method, *words, settings); };
    });
  }
}

}  // namespace axisctl
