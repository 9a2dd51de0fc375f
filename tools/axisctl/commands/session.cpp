#include <iostream>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "farm/mirror/mirror_thread.hpp"
#include "tools/axisctl/commands/command.hpp"

namespace axisctl {

Expected<Client> connect_to_farm(const Settings& settings) {
  auto socket = settings.farm->connect();
  if (!socket) return fail(ExitStatus::Failed, socket.error());
  return Client{settings.farm->place(), *std::move(socket)};
}

Expected<void> expect_no_farm(const Settings& settings, std::string_view what, std::string_view why) {
  if (settings.farm == nullptr) return {};
  return fail(ExitStatus::Usage, fmt::format("{}: not with --farm: {}", what, why));
}

Expected<Session> Session::open(const Settings& settings) {
  if (settings.farm != nullptr) {
    auto farm = connect_to_farm(settings);
    if (!farm) return tl::unexpected{farm.error()};
    auto unit = choose_unit(*farm, settings.address);
    if (!unit) return tl::unexpected{unit.error()};
    return Session{*std::move(farm), *std::move(unit)};
  }
  auto target = choose_target(settings.address);
  if (!target) return tl::unexpected{target.error()};
  auto client = Client::connect(target->path);
  if (!client) return tl::unexpected{client.error()};
  return Session{*std::move(client), std::move(target->unit)};
}

Expected<Session> Session::open_to_all(const Settings& settings) {
  if (settings.farm == nullptr || settings.address.label || settings.address.node) return open(settings);
  auto farm = connect_to_farm(settings);
  if (!farm) return tl::unexpected{farm.error()};
  return Session{*std::move(farm), {}};
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
