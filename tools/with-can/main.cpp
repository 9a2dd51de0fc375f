#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <random>

#include <fmt/format.h>
#include <unistd.h>

#include "can/userbus/path.hpp"
#include "can/userbus/start_hub.hpp"
#include "os/own_program.hpp"
#include "tools/with-can/command_line.hpp"
#include "tools/with-can/elf_file.hpp"
#include "tools/with-can/program_file.hpp"
#include "version/version.hpp"

namespace {

using with_can::CommandLine;

constexpr int kFailure = 1;
constexpr int kUsage = 2;

/// Prints one line on what is wrong; returns @p status.
int fail(int status, std::string_view message) {
  std::cerr << "with-can: " << message << '\n';
  return status;
}

/// A path that nobody uses; the hub removes it when its last member has left.
std::string new_path() {
  userbus::Path folder{};
  if (!userbus::default_folder(folder)) return std::string(userbus::kLongestPath + 1, '/');
  std::random_device random;
  return fmt::format("{}/can-bus-{}-{:08x}", folder.text, ::getpid(), random());
}

/// The path of the bus, from the root; longer than kLongestPath if that is what it is.
std::string bus_path(const std::string& chosen) {
  userbus::Path standard{};
  if (chosen.empty() && !userbus::default_path(standard)) {
    const char* const variable = std::getenv("CAN_BUS");
    return variable != nullptr ? variable : std::string(userbus::kLongestPath + 1, '/');
  }
  return std::filesystem::absolute(chosen.empty() ? standard.text : chosen).lexically_normal().string();
}

/// Why $LD_PRELOAD cannot name @p library; nullptr: it can.
const char* trouble_with(const std::string& library) {
  std::error_code ignored;
  if (!std::filesystem::exists(library, ignored)) return "is missing";
  if (library.find_first_of(" :") != std::string::npos)
    return "has a blank or a colon in its path, which divides names in LD_PRELOAD";
  return nullptr;
}

/// Puts @p library before what is to be preloaded already.
void preload(const std::string& library) {
  const char* const before = std::getenv("LD_PRELOAD");
  const std::string others = before != nullptr ? before : "";
  if (others.starts_with(library)) return;  // with-can runs with-can
  ::setenv("LD_PRELOAD", (others.empty() ? library : library + ":" + others).c_str(), 1);
}

/// How a bus differs from what was asked for.
std::string difference(const CommandLine& line) {
  const std::string rate = fmt::format("runs at another bit rate than {} bit/s", line.bit_rate);
  const std::string time = fmt::format("goes by another time than {}", line.time);
  if (line.time.empty()) return rate;
  return line.bit_rate.empty() ? time : rate + ", or " + time;
}

/// Starts the bus with the bit rate and the time that are wanted, or finds it running so. Returns an exit status.
int start_bus(const std::string& bus, const CommandLine& line, const std::string& folder) {
  const char* const chosen = std::getenv("CAN_HUB");
  const std::string hub = chosen != nullptr && *chosen != '\0' ? chosen : folder + "/canhub";
  const char* const bit_rate = line.bit_rate.empty() ? nullptr : line.bit_rate.c_str();
  const char* const time = line.time.empty() ? nullptr : line.time.c_str();
  switch (userbus::start_hub(hub.c_str(), bus.c_str(), bit_rate, time)) {
    case userbus::StartStatus::Served:
      return 0;
    case userbus::StartStatus::Different:
      return fail(kFailure, fmt::format("the bus {} {}", bus, difference(line)));
    case userbus::StartStatus::InUse:
      return fail(kFailure, fmt::format("{}: is in use by something that is no CAN bus", bus));
    case userbus::StartStatus::Failed:
    case userbus::StartStatus::Usage:
      break;
  }
  return fail(kFailure, fmt::format("{}: {} does not serve it: {}", bus, hub, std::strerror(errno)));
}

int run(const CommandLine& line) {
  const std::string bus = line.own_bus ? new_path() : bus_path(line.bus);
  if (bus.size() > userbus::kLongestPath)
    return fail(kUsage, fmt::format("the path of the bus has {} bytes, at most {} are possible: {}", bus.size(),
                                    userbus::kLongestPath, bus));
  const with_can::FoundProgram program = with_can::find_program(line.command.front());
  if (program.verdict.status != 0) return fail(program.verdict.status, program.verdict.message);
  if (const with_can::Verdict verdict = with_can::judge_program(program.path); verdict.status != 0)
    return fail(verdict.status, verdict.message);

  const std::filesystem::path folder = os::program_folder();
  const std::string library = (folder / "../lib/axisd/libcan-preload.so").lexically_normal().string();
  if (const char* const trouble = trouble_with(library)) return fail(kFailure, library + ": " + trouble);
  ::setenv("CAN_BUS", bus.c_str(), 1);
  if (!line.bit_rate.empty()) ::setenv("CAN_BITRATE", line.bit_rate.c_str(), 1);
  if (!line.time.empty()) ::setenv("CAN_TIME", line.time.c_str(), 1);
  if (!line.bit_rate.empty() || !line.time.empty())
    if (const int status = start_bus(bus, line, folder.string()); status != 0) return status;
  preload(library);
  ::execv(program.path.c_str(), line.command.data());
  // execvp(3) gives what the kernel does not take to the shell: right for a script, not for a damaged program.
  if (errno == ENOEXEC && !with_can::claims_to_be_elf(program.path))
    ::execvp(line.command.front(), line.command.data());
  return fail(with_can::kNotExecutable, fmt::format("{}: {}", line.command.front(), std::strerror(errno)));
}

}  // namespace

int main(int argc, char** argv) try {
  const auto line = with_can::read_command_line({argv + 1, static_cast<std::size_t>(argc - 1)});
  if (!line) {
    fail(kUsage, line.error());
    std::cerr << "usage: with-can [--bus PATH | --private] [--bitrate N] [--time T] [--] COMMAND [ARGUMENT...]\n";
    return kUsage;
  }
  if (line->help) {
    std::cout << with_can::kHelp;
    return 0;
  }
  if (line->version) {
    std::cout << version::line("with-can") << '\n';
    return 0;
  }
  return run(*line);
} catch (const std::exception& error) {
  return fail(kFailure, error.what());
}
