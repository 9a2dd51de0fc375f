#include "tools/axisctl/connection/target.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <sys/socket.h>

#include "control/discovery/socket_files.hpp"
#include "control/socket_name.hpp"
#include "os/descriptor.hpp"
#include "tools/axisctl/connection/client.hpp"
#include "tools/axisctl/connection/whole_answer.hpp"

namespace axisctl {

namespace {

using nlohmann::json;

bool fits(const Address& address, std::string_view label, std::string_view station) {
  const bool is_on_bus = !address.label || *address.label == label;
  const bool is_any = address.node == kAnyUnconfigured && control::is_unconfigured(station);
  return is_on_bus && (!address.node || *address.node == station || is_any);
}

/// Whether @p unit, of a list of units, can be meant.
bool fits(const Address& address, const json& unit) {
  const std::string name = unit.value("unit", "");
  const std::size_t slash = name.rfind('/');
  const std::string_view whole{name};
  return slash != std::string::npos && fits(address, whole.substr(0, slash), whole.substr(slash + 1));
}

/// Whether nobody listens at @p path any more. A socket of another type is refused before the daemon notices.
bool is_left_behind(const std::string& path) {
  const auto address = control::socket_address(path);
  const os::Descriptor socket{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  if (!address || !socket) return false;
  return ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0 &&
         errno == ECONNREFUSED;
}

std::string text_of(const Address& address) {
  std::string text = address.label ? fmt::format("on {} ", *address.label) : "";
  if (!address.node) return fmt::format("on {}", *address.label);
  const bool is_unconfigured = address.node == kAnyUnconfigured || control::is_unconfigured(*address.node);
  return text + (is_unconfigured ? "without node-ID" : "with node-ID " + *address.node);
}

/// The units of the daemon at @p path that @p address means, where one socket serves many.
std::vector<Target> units_of(const std::string& path, const Address& address) {
  std::vector<Target> found;
  auto client = Client::connect(path);
  const auto units = client.and_then(list_units);
  if (!units) return found;
  for (const json& unit : *units)
    if (fits(address, unit)) found.push_back({path, unit.value("unit", "")});
  return found;
}

/// Every unit that @p address can mean.
std::vector<Target> candidates(const Address& address) {
  std::vector<Target> found;
  const bool says_nothing = !address.label && !address.node;
  for (const control::SocketFile& file : control::socket_files()) {
    if (file.name && fits(address, file.name->label, file.name->station)) found.push_back({file.path});
    if (file.name) continue;
    if (says_nothing) {
      found.push_back({file.path});
      continue;
    }
    for (Target& target : units_of(file.path, address)) found.push_back(std::move(target));
  }
  return found;
}

std::string text_of(const Target& target) {
  return target.unit.empty() ? target.path : fmt::format("{} ({})", target.unit, target.path);
}

}  // namespace

Expected<Target> choose_target(const Address& address) {
  const bool says_all = address.label && address.node;
  if (address.socket) {
    if (!address.names_unit) return Target{*address.socket};
    const std::string node = address.node.value_or("");
    return Target{*address.socket, address.label ? *address.label + "/" + node : node};
  }
  std::vector<Target> found = candidates(address);
  if (found.size() > 1) std::erase_if(found, [](const Target& target) { return is_left_behind(target.path); });
  if (found.size() == 1) return found.front();
  if (found.size() > 1) {
    Failure several{
        .status = ExitStatus::Usage,
        .message = "several units fit; choose one with --unit, --socket, or --interface and --node-id:"};
    for (const Target& target : found) several.choices.push_back(text_of(target));
    return tl::unexpected{std::move(several)};
  }
  if (says_all && !address.names_unit) return Target{control::default_socket_path(*address.label, *address.node)};
  if (address.label || address.node)
    return fail(ExitStatus::NotReachable, fmt::format("no daemon {} runs: it would have its control socket in {}",
                                                      text_of(address), control::runtime_directory()));
  return Target{control::default_socket_path(control::kDefaultInterface, control::kDefaultNode)};
}

Expected<json> list_units(Client& client) {
  const auto ask = [&client](std::string_view method, json params) {
    return client.ask({method, std::move(params)});
  };
  auto result = ask_whole(ask, "units", json::object());
  if (!result) return result;
  json units = result->is_object() ? result->value("units", json::array()) : json::array();
  if (!units.is_array()) return fail(ExitStatus::NotUnderstood, client.name() + ": expected a list of units");
  std::erase_if(units.get_ref<json::array_t&>(), [](const json& unit) { return !unit.is_object(); });
  return units;
}

Expected<std::string> choose_unit(Client& farm, const Address& address) {
  const auto none = [&] {
    const bool says_nothing = !address.label && !address.node;
    return fail(ExitStatus::NotReachable, fmt::format("{}: the farm has no unit{}", farm.name(),
                                                      says_nothing ? "" : ' ' + text_of(address)));
  };
  if (address.label && address.node && address.node != kAnyUnconfigured) {
    std::string name = *address.label + '/' + *address.node;
    const auto known = farm.ask({"units", {{"unit", name}}});
    if (known) return name;
    if (known.error().status != status_of(control::ErrorCode::UnknownUnit)) return tl::unexpected{known.error()};
    return none();
  }
  auto units = list_units(farm);
  if (!units) return tl::unexpected{units.error()};
  std::erase_if(units->get_ref<json::array_t&>(), [&](const json& unit) { return !fits(address, unit); });
  if (units->empty()) return none();
  if (units->size() == 1) return units->front().value("unit", "");
  Failure several{.status = ExitStatus::Usage,
                  .message = "several units fit; choose one with --unit, or --interface and --node-id:"};
  for (const json& unit : *units)
    several.choices.push_back(fmt::format("{} (host {})", unit.value("unit", ""), unit.value("host", "")));
  return tl::unexpected{std::move(several)};
}

std::vector<std::string> served_sockets() {
  std::vector<std::string> paths;
  for (const control::SocketFile& file : control::socket_files())
    if (!is_left_behind(file.path)) paths.push_back(file.path);
  return paths;
}

}  // namespace axisctl
