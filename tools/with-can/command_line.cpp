#include "tools/with-can/command_line.hpp"

#include <array>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "can/userbus/bit_rate.hpp"
#include "can/userbus/time.hpp"

namespace with_can {

const std::string_view kHelp =
    R"(usage: with-can [--bus PATH | --private] [--bitrate N] [--time T] [--] COMMAND [ARGUMENT...]

Runs COMMAND with CAN sockets on a bus in user space, where the kernel needs no CAN. COMMAND is any program that
uses SocketCAN and is linked with the C library dynamically; scripts are, as their interpreters are.

  --bus PATH    the bus is at PATH (default: $CAN_BUS, else $XDG_RUNTIME_DIR/can-bus, else /run/can-bus
                for root and /tmp/can-bus-UID/can-bus for others)
  --private     a new bus for COMMAND and whatever that starts, which find its path in $CAN_BUS
  --bitrate N   frames take the time that they take at N bit/s, 1000 to 1000000, or 0: no time (default: as the
                bus is; on a new one they take no time)
  --time T      COMMAND lives by the time of the bus: virtual, stepped, scaled=K (K times as quick, 0.001 to 1000)
                or real, the machine's (default: $CAN_TIME, else real)
  --help        this text
  --version     the version

Exit status:
   -  that of COMMAND, if it ran
   1  the bus runs at another bit rate or by another time, or cannot be started; the library is missing
   2  wrong usage, a path over 107 bytes, or a program into which nothing can be preloaded
 126  COMMAND cannot be executed
 127  COMMAND is not found
)";

namespace {

using Result = tl::expected<CommandLine, std::string>;

std::optional<std::string> store_bus(CommandLine& line, std::string_view value) {
  if (value.empty()) return "--bus: expected a path, got nothing";
  line.bus = value;
  return std::nullopt;
}

std::optional<std::string> store_bit_rate(CommandLine& line, std::string_view value) {
  std::uint32_t rate = 0;
  if (!userbus::read_bit_rate(value.data(), value.size(), rate))
    return fmt::format("--bitrate: expected {}, got \"{}\"", userbus::kBitRateRule, value);
  line.bit_rate = value;
  return std::nullopt;
}

std::optional<std::string> store_time(CommandLine& line, std::string_view value) {
  userbus::TimeWish wish{};
  if (!userbus::read_time(value.data(), value.size(), wish))
    return fmt::format("--time: expected {}, got \"{}\"", userbus::kTimeRule, value);
  line.time = value;
  return std::nullopt;
}

/// An option that has a value; storing it may go wrong.
struct ValueOption {
  std::string_view name;
  std::optional<std::string> (*store)(CommandLine& line, std::string_view value);
};

constexpr std::array kValueOptions{ValueOption{"--bus", store_bus}, ValueOption{"--bitrate", store_bit_rate},
                                   ValueOption{"--time", store_time}};

/// The option that @p word is or begins, as "--bus=PATH".
const ValueOption* value_option(std::string_view word) {
  const std::string_view name = word.substr(0, word.find('='));
  for (const ValueOption& option : kValueOptions)
    if (option.name == name) return &option;
  return nullptr;
}

/// Reads @p option from the front of @p words, and its value.
std::optional<std::string> take(const ValueOption& option, CommandLine& line, std::span<char* const>& words) {
  const std::string_view word = words.front();
  words = words.subspan(1);
  if (const std::size_t equals = word.find('='); equals != std::string_view::npos)
    return option.store(line, word.substr(equals + 1));
  if (words.empty()) return fmt::format("{}: expected a value", option.name);
  const std::string_view value = words.front();
  words = words.subspan(1);
  return option.store(line, value);
}

}  // namespace

Result read_command_line(std::span<char* const> words) {
  CommandLine line;
  while (!words.empty()) {
    const std::string_view word = words.front();
    line.help = word == "--help";
    line.version = word == "--version";
    if (line.help || line.version) return line;
    if (word == "--private") {
      line.own_bus = true;
      words = words.subspan(1);
      continue;
    }
    const ValueOption* const option = value_option(word);
    if (option == nullptr && word.starts_with('-') && word != "--")
      return tl::unexpected{fmt::format("unknown option {}", word)};
    if (option == nullptr) {
      line.command = word == "--" ? words.subspan(1) : words;
      break;
    }
    if (std::optional<std::string> error = take(*option, line, words)) return tl::unexpected{std::move(*error)};
  }
  if (line.own_bus && !line.bus.empty())
    return tl::unexpected{std::string{"expected --bus or --private, got both"}};
  if (line.command.empty()) return tl::unexpected{std::string{"expected a command to run"}};
  return line;
}

}  // namespace with_can
