#include "tools/axisctl/farm_option.hpp"

#include <cstdlib>

#include <CLI/CLI.hpp>

#include "farm/options/farm_option.hpp"

namespace axisctl {
namespace {

constexpr const char* kVariable = "AXISD_FARM";

}  // namespace

void add_farm_options(CLI::App& app, FarmOption& option) {
  app.add_option("--farm", option.url,
                 "Farm whose units are meant, nats://HOST[:PORT]/FARM or tls:// ($AXISD_FARM if not given)")
      ->type_name("URL");
  nats::add_server_options(app, option.server, "--farm");
}

Expected<std::unique_ptr<farm::MirrorThread>> open_farm(const FarmOption& option,
                                                        const std::optional<std::string>& socket) {
  if (option.url && socket) return fail(ExitStatus::Usage, "--farm does not go with --socket");
  const char* const variable = std::getenv(kVariable);
  const bool is_in_environment = !option.url && !socket && variable != nullptr && *variable != '\0';
  if (!option.url && !is_in_environment) {
    if (option.server.are_given())
      return fail(ExitStatus::Usage, "--credentials, --tls-... and --plain go with --farm");
    return nullptr;
  }
  const std::string name = is_in_environment ? kVariable : "--farm";
  const std::string url = is_in_environment ? variable : *option.url;
  const auto farm = farm::read_farm(url, option.server, name);
  if (!farm) return fail(ExitStatus::Usage, farm.error());
  return std::make_unique<farm::MirrorThread>(*farm, "axisctl");
}

}  // namespace axisctl
