#include <csignal>
#include <cstdio>
#include <exception>
#include <utility>

#include <sys/resource.h>

#include "can/port/address.hpp"
#include "control/socket_name.hpp"
#include "daemon/base/log.hpp"
#include "daemon/program/configuration_file.hpp"
#include "daemon/program/options.hpp"
#include "daemon/program/program.hpp"

namespace {

constexpr int kFailure = 1;
constexpr int kUsage = 2;

std::string default_control_path(const axisd::UnitsConfiguration& configuration) {
  if (configuration.is_list) return control::common_socket_path();
  const axisd::Configuration& unit = configuration.units.front();
  return control::default_socket_path(bus::label(unit.address), unit.node_id);
}

std::string control_path(const axisd::Options& options, const axisd::UnitsConfiguration& configuration) {
  if (options.control == "none") return "";
  std::string path = options.control.empty() ? default_control_path(configuration) : options.control;
  if (const auto address = control::socket_address(path); !address) {
    throw axisd::ConfigurationError{"--control: " + address.error()};
  }
  return path;
}

/// Many units have more descriptors than a process may have by default; where that is all it may have, opening
/// them says so.
void allow_many_descriptors() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

int serve(const axisd::Options& options) {
  axisd::UnitsConfiguration configuration = axisd::load_configuration(options);
  axisd::Assignment assignment{.units = {}, .threads = configuration.threads, .control = {}};
  assignment.control = control_path(options, configuration);
  if (options.check_config) return 0;
  if (configuration.is_list) allow_many_descriptors();
  assignment.units = std::move(configuration.units);
  assignment.state_root = axisd::state_root(options.state_directory);
  const axisd::Log log{options.log_level};
  axisd::Program program{assignment, log};
  program.run();
  return 0;
}

int fail(const std::exception& error, int status) {
  std::fprintf(stderr, "axisd: %s\n", error.what());
  return status;
}

}  // namespace

int main(int count, char** words) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the log that goes away must not take the drive with it
  std::signal(SIGXFSZ, SIG_IGN);  // nor must a limit on the size of files: it is an error of the write
  try {
    const auto options = axisd::parse_command_line(count, words);
    return options ? serve(*options) : 0;
  } catch (const axisd::UsageError& error) {
    return fail(error, kUsage);
  } catch (const axisd::ConfigurationError& error) {
    return fail(error, kUsage);
  } catch (const std::exception& error) {
    return fail(error, kFailure);
  }
}
