#include <iostream>
#include <utility>

#include <CLI/CLI.hpp>

#include "tools/axisctl/commands/command.hpp"

namespace axisctl {

Expected<Session> Session::open(const Settings& settings) {
  auto target = choose_target(settings.address);
  if (!target) return tl::unexpected{target.error()};
  auto client = Client::connect(target->path);
  if (!client) return tl::unexpected{client.error()};
  return Session{*std::move(client), std::move(target->unit)};
}

Expected<nlohmann::json> Session::ask(std::string_view method, nlohmann::json params) {
  if (!unit_.empty()) params["unit"] = unit_;
  return client_.ask({method, std::move(params)});
}

CLI::App& subcommand(CLI::App& app, std::string_view name, std::string_view summary) {
  const std::string text{name};
  const auto present = app.get_subcommands([&text](const CLI::App* sub) { return sub->get_name() == text; });
  if (!present.empty()) return *present.front();
  CLI::App* const added = app.add_subcommand(text, std::string{summary});
  added->fallthrough();
  return *added;
}

Expected<void> print_line(std::string_view line) {
  std::cout << line << std::endl;  // whoever reads it wants it now
  if (std::cout) return {};
  return fail(ExitStatus::Failed, "standard output: cannot be written");
}

}  // namespace axisctl
