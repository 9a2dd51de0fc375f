#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "can/nats/bus.hpp"
#include "can/port/address.hpp"
#include "can/userbus/path.hpp"
#include "can/userbus/time.hpp"
#include "cli/usage_error.hpp"

namespace canhub {

/// Which faults are to be taken back.
struct TakeBack {
  std::optional<std::uint32_t> number;  ///< nothing: all
};

/// What the command line asks for.
struct Options {
  userbus::Path path{};
  std::optional<std::uint32_t> bit_rate;  ///< bit/s; 0 = frames take no time
  std::optional<userbus::TimeWish> time;  ///< whose time the bus has
  bool on_demand = false;
  std::vector<bus::Address> bridges;
  std::string socketcand;         ///< HOST:PORT, empty = none
  std::optional<nats::Bus> join;  ///< the bus of several hosts that this one is a part of
  bool status = false;
  std::vector<std::string> with;    ///< faults to begin with, as they were written
  std::vector<std::string> inject;  ///< faults for a hub that runs
  bool injected = false;
  std::optional<TakeBack> take_back;
  bool json = false;

  /// Whether a hub that runs is spoken to about its faults.
  [[nodiscard]] bool is_about_faults() const noexcept { return !inject.empty() || injected || take_back; }
};

using cli::UsageError;

/// Reads the command line; nothing if it asked for help or version, which then is printed. UsageError.
std::optional<Options> parse_command_line(int count, const char* const* words);

}  // namespace canhub
