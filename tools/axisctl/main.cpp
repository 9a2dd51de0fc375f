#include <exception>
#include <iostream>
#include <string>

#include "can/port/address.hpp"
#include "control/words.hpp"
#include "tools/axisctl/client.hpp"
#include "tools/axisctl/command_line.hpp"
#include "tools/axisctl/printable.hpp"
#include "tools/axisctl/printer.hpp"

namespace {

using axisctl::Invocation;

constexpr int kSuccess = 0;
constexpr int kFailure = 1;
constexpr int kUsage = 2;

int error(int status, const std::string& message) {
  std::cerr << "axisctl: " << message << '\n';
  return status;
}

int run(Invocation& invocation) {
  const control::Method& method = *invocation.method;
  const auto parameters = control::parse_words(method, invocation.words);
  if (!parameters) return error(kUsage, parameters.error());
  if (invocation.interface) {
    const auto address = bus::parse_address(*invocation.interface);
    if (!address)
      return error(kUsage, "--interface: expected " + address.error() + ", got \"" + *invocation.interface + '"');
    invocation.address.label = bus::label(*address);
  }
  const auto path = axisctl::choose_socket(invocation.address);
  if (!path) return error(path.error().several ? kUsage : kFailure, path.error().message);
  const auto result = axisctl::ask(*path, {method.name, *parameters});
  if (!result) return error(kFailure, axisctl::printable(control::in_words_of(method, result.error().message)));
  if (invocation.json)
    std::cout << axisctl::printable(result->dump()) << '\n';
  else
    axisctl::print_result(std::cout, method.name, axisctl::printable_values(*result));
  std::cout.flush();
  return std::cout ? kSuccess : kFailure;
}

}  // namespace

int main(int argc, char** argv) {
  axisctl::CommandLine line;
  try {
    line.parse(argc, argv);
    const int status = line.invocation().method != nullptr ? run(line.invocation()) : kSuccess;
    std::cout.flush();
    return std::cout ? status : kFailure;
  } catch (const CLI::ParseError& thrown) {
    // Help and version are thrown too.
    return thrown.get_exit_code() == 0 ? line.exit(thrown) : error(kUsage, line.complaint(thrown));
  } catch (const std::exception& thrown) {
    return error(kFailure, thrown.what());
  }
}
