#include <exception>
#include <iostream>
#include <string>

#include "can/port/address.hpp"
#include "control/socket_name.hpp"
#include "farm/naming/unit_name.hpp"
#include "tools/axisctl/command_line.hpp"
#include "tools/axisctl/print/printable.hpp"

namespace {

using axisctl::ExitStatus;
using axisctl::Expected;
using axisctl::Failure;
using axisctl::Invocation;

int status_of(ExitStatus status) {
  return static_cast<int>(status);
}

int error(ExitStatus status, const std::string& message) {
  std::cerr << "axisctl: " << message << '\n';
  return status_of(status);
}

/// What went wrong, for a program too if it has asked for JSON.
int report(const Failure& failure, bool as_json) {
  if (as_json) {
    nlohmann::json object = failure.details;
    object["message"] = failure.message;
    if (!failure.choices.empty()) object["choices"] = failure.choices;
    object["exit_status"] = status_of(failure.status);
    std::cout << axisctl::printable(nlohmann::json{{"error", object}}.dump(
                     -1, ' ', false, nlohmann::json::error_handler_t::replace))
              << '\n';
  }
  const int status = error(failure.status, axisctl::printable(failure.message));
  for (const std::string& choice : failure.choices) std::cerr << "  " << axisctl::printable(choice) << '\n';
  return status;
}

/// The name of the bus @p interface in control sockets; in a farm it is one. As part of @p option --unit it may be
/// one that `units` has shown.
Expected<std::string> label_of(const std::string& option, const std::string& interface, bool in_farm) {
  if (in_farm && farm::is_name(interface)) return interface;
  if (in_farm)
    return fail(ExitStatus::Usage, option + ": expected the name of a bus of the farm, got \"" + interface + '"');
  const auto address = bus::parse_address(interface);
  if (address) return bus::label(*address);
  if (option == "--unit" && farm::is_name(interface)) return interface;
  return fail(ExitStatus::Usage, option + ": expected " + address.error() + ", got \"" + interface + '"');
}

/// The interface and node that the options name.
Expected<void> complete(Invocation& invocation) {
  axisctl::Address& address = invocation.settings.address;
  const bool in_farm = invocation.settings.farm != nullptr;
  invocation.settings.style = axisctl::style_of_output(invocation.brief);
  if (invocation.interface) {
    const auto label = label_of("--interface", *invocation.interface, in_farm);
    if (!label) return tl::unexpected{label.error()};
    address.label = *label;
    invocation.settings.interface = *invocation.interface;
  }
  if (!invocation.unit) return {};
  if (address.label || address.node)
    return fail(ExitStatus::Usage, "--unit goes with neither --interface nor --node-id");
  const std::size_t slash = invocation.unit->rfind('/');
  const std::string node = invocation.unit->substr(slash == std::string::npos ? 0 : slash + 1);
  if (!control::is_station(node))
    return fail(ExitStatus::Usage, "--unit: expected NODE or BUS/NODE, got \"" + *invocation.unit + '"');
  address.names_unit = true;
  address.node = node;
  if (slash == std::string::npos) return {};
  const auto label = label_of("--unit", invocation.unit->substr(0, slash), in_farm);
  if (!label) return tl::unexpected{label.error()};
  address.label = *label;
  return {};
}

int run(Invocation& invocation) {
  const auto farm = axisctl::open_farm(invocation.farm, invocation.settings.address.socket);
  if (!farm) return report(farm.error(), invocation.settings.json);
  invocation.settings.farm = farm->get();
  if (const auto completed = complete(invocation); !completed)
    return report(completed.error(), invocation.settings.json);
  const auto done = invocation.run(invocation.settings);
  std::cout.flush();
  if (!done) return report(done.error(), invocation.settings.json);
  return std::cout ? status_of(ExitStatus::Done) : error(ExitStatus::Failed, "standard output: cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  axisctl::CommandLine line;
  try {
    line.parse(argc, argv);
    if (line.invocation().run) return run(line.invocation());
    std::cout.flush();
    return status_of(std::cout ? ExitStatus::Done : ExitStatus::Failed);
  } catch (const CLI::ParseError& thrown) {
    // Help and version are thrown too.
    return thrown.get_exit_code() == 0 ? line.exit(thrown) : error(ExitStatus::Usage, line.complaint(thrown));
  } catch (const std::exception& thrown) {
    return error(ExitStatus::Failed, thrown.what());
  }
}
