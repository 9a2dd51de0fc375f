#include "farm/agent/program/program.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <systemd/sd-daemon.h>

#include "farm/agent/process/program_start.hpp"
#include "farm/documents/numbers.hpp"
#include "service/clock.hpp"
#include "version/version.hpp"

namespace farm::agent {
namespace {

/// For giving units away: they are stopped, and what they have saved goes to the server.
constexpr std::chrono::seconds kDrainPatience{30};

std::uint64_t random_instance() {
  std::random_device source;
  return std::uniform_int_distribution<std::uint64_t>{1, kGreatestNumber}(source);
}

std::string present_time() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

std::vector<std::string> unit_options(const Options& options) {
  std::vector<std::string> words{"--log-level", options.log_level_name};
  if (!options.control_group.empty()) words.insert(words.end(), {"--control-group", options.control_group});
  return words;
}

Assignment assignment_of(const Options& options) {
  return {
      .farm = options.farm,
      .self = {.host = options.host,
               .instance = random_instance(),
               .version = std::string{version::number()},
               .since = present_time(),
               .capacity = options.capacity,
               .buses = options.buses},
      .folders = {.runtime = options.runtime, .state = options.state},
      .units = {.program = program_beside("axisd"), .options = unit_options(options)},
      .hubs = {
          .program = program_beside("canhub"), .server = options.farm.server.url, .options = options.security}};
}

void make_folder(const std::string& path, mode_t mode) {
  std::error_code error;
  const bool is_new = std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error{fmt::format("{}: cannot be made: {}", path, error.message())};
  if (is_new) ::chmod(path.c_str(), mode);
}

/// One agent in a folder: two would start each unit twice.
os::Descriptor take_folders(const Options& options) {
  constexpr mode_t kForAllToLook = 0755;
  make_folder(options.runtime, kForAllToLook);
  make_folder(options.state, S_IRWXU);
  const std::string path = options.runtime + "/agent.lock";
  os::Descriptor lock{::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR)};
  if (!lock) throw std::runtime_error{fmt::format("{}: {}", path, std::generic_category().message(errno))};
  if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0)
    throw std::runtime_error{fmt::format("{}: another agent works in this folder", path)};
  return lock;
}

}  // namespace

Program::Program(const Options& options, const axisd::Log& log)
    : log_{log},
      drain_on_stop_{options.drain_on_stop},
      lock_{take_folders(options)},
      events_{[this] { ++stops_; }},
      loop_{events_, log},
      agent_{events_, assignment_of(options), log} {}

bool Program::run() {
  sd_notify(0, "READY=1");
  while (stops_ == 0) wait(canopen::kNever);
  sd_notify(0, "STOPPING=1");
  return !drain_on_stop_ || drain();
}

/// Who asks a second time does not want to wait.
bool Program::drain() {
  agent_.drain();
  const canopen::TimePoint end = axisd::read_clock() + kDrainPatience;
  while (!agent_.is_empty() && stops_ == 1 && axisd::read_clock() < end) wait(end);
  if (agent_.is_empty()) return true;
  log_.warning("units are left that could not be given away");
  return false;
}

void Program::wait(canopen::TimePoint until) {
  if (loop_.turn(std::min(until, agent_.due()))) agent_.advance();
}

}  // namespace farm::agent
