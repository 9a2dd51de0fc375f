#include <csignal>
#include <cstdio>
#include <exception>
#include <span>

#include "can/port/address.hpp"
#include "control/socket_name.hpp"
#include "daemon/base/log.hpp"
#include "daemon/program/configuration_file.hpp"
#include "daemon/program/options.hpp"
#include "daemon/program/program.hpp"

namespace {

constexpr int kFailure = 1;
constexpr int kUsage = 2;

std::string control_path(const axisd::Options& options, const axisd::Configuration& configuration) {
  if (options.control == "none") return "";
  std::string path = options.control.empty()
                         ? control::default_socket_path(bus::label(configuration.address), configuration.node_id)
                         : options.control;
  if (const auto address = control::socket_address(path); !address) {
    throw axisd::ConfigurationError{"--control: " + address.error()};
  }
  return path;
}

int serve(const axisd::Options& options) {
  axisd::Assignment unit{.configuration = axisd::load_configuration(options), .control = {}};
  unit.control = control_path(options, unit.configuration);
  if (options.check_config) return 0;
  const axisd::Log log{options.log_level};
  axisd::Program program{std::span{&unit, 1}, axisd::state_root(options.state_directory), log};
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
