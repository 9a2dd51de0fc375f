#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <grp.h>
#include <sys/resource.h>

#include "control/socket_name.hpp"
#include "daemon/program/bus_time.hpp"
#include "daemon/program/configuration_file.hpp"
#include "daemon/program/options.hpp"
#include "daemon/program/program.hpp"
#include "os/missing_memory.hpp"
#include "service/log.hpp"

namespace {

std::string default_control_path(const axisd::UnitsConfiguration& configuration) {
  if (configuration.is_list) return control::common_socket_path();
  const axisd::Configuration& unit = configuration.units.front();
  return control::default_socket_path(axisd::bus_of(unit), axisd::station_of(unit));
}

std::string control_path(const axisd::Options& options, const axisd::UnitsConfiguration& configuration) {
  if (options.control == "none") return "";
  std::string path = options.control.empty() ? default_control_path(configuration) : options.control;
  if (const auto address = control::socket_address(path); !address) {
    throw axisd::ConfigurationError{"--control: " + address.error()};
  }
  return path;
}

/// Whose members may use the control socket, if anybody's.
std::optional<gid_t> control_group(const axisd::Options& options, const axisd::UnitsConfiguration& configuration) {
  const bool is_option = !options.control_group.empty();
  const std::string& name = is_option ? options.control_group : configuration.control_group;
  if (name.empty()) return std::nullopt;
  if (const ::group* const known = ::getgrnam(name.c_str())) return known->gr_gid;
  throw axisd::ConfigurationError{fmt::format("{}: expected a group of this machine, got \"{}\"",
                                              is_option ? "--control-group" : "control_group", name)};
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
  assignment.control.path = control_path(options, configuration);
  assignment.control.group = control_group(options, configuration);
  if (options.check_config) return axisd::kDone;
  if (configuration.is_list) allow_many_descriptors();
  assignment.units = std::move(configuration.units);
  assignment.state_root = axisd::state_root(options.state_directory);
  const axisd::Log log{options.log_level};
  const auto time = axisd::join_bus_time(assignment.units);
  axisd::Program program{assignment, log, time.get()};
  program.run();
  return axisd::kDone;
}

int fail(const std::exception& error, int status) {
  std::fprintf(stderr, "axisd: %s\n", error.what());
  return status;
}

}  // namespace

int main(int count, char** words) {
  os::end_if_memory_is_missing("axisd", axisd::kFailure);
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the log that goes away must not take the drive with it
  std::signal(SIGXFSZ, SIG_IGN);  // nor must a limit on the size of files: it is an error of the write
  try {
    const auto options = axisd::parse_command_line(count, words);
    return options ? serve(*options) : axisd::kDone;
  } catch (const axisd::UsageError& error) {
    return fail(error, axisd::kUsage);
  } catch (const axisd::ConfigurationError& error) {
    return fail(error, axisd::kUsage);
  } catch (const std::exception& error) {
    return fail(error, axisd::kFailure);
  }
}
