#include <algorithm>
#include <iostream>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

#include "control/methods.hpp"
#include "control/words.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/print/printable.hpp"

namespace axisctl {
namespace {

using nlohmann::json;
using AllWords = std::vector<control::Words>;

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

/// Puts what the lists of @p page hold behind those of @p result.
void append(json& result, const json& page) {
  for (const auto& item : page.items()) {
    json& own = result[item.key()];
    if (!own.is_array() || !item.value().is_array()) continue;
    for (const json& element : item.value()) own.push_back(element);
  }
}

/// The result of @p method; the pages of a long one together, unless a part was asked for.
Expected<json> ask_whole(Session& session, const control::Method& method, json params) {
  auto result = session.ask(method.name, params);
  const bool has_pages = std::ranges::count(method.parameters, "from", &control::Parameter::key) == 1 &&
                         !params.contains("from") && !params.contains("count");
  if (!has_pages || !result || !result->is_object()) return result;
  for (json next = result->value("next", json{}); next.is_number_unsigned();) {
    params["from"] = next;
    const auto page = session.ask(method.name, params);
    if (!page) return page;
    append(*result, *page);
    const json before = std::move(next);
    next = page->value("next", json{});
    if (next.is_number_unsigned() && next <= before) break;
  }
  result->erase("next");
  return result;
}

Expected<void> run_method(const control::Method& method, const AllWords& words, const Settings& settings) {
  const auto params = control::parse_words(method, words);
  if (!params) return fail(ExitStatus::Usage, params.error());
  auto session = Session::open(settings);
  if (!session) return tl::unexpected{session.error()};
  auto result = ask_whole(*session, method, *params);
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
