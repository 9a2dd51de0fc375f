#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "modbus/service.hpp"

namespace modbus {

/// Registers in memory: each reads as the low byte of its number until it is written; some cannot be written.
struct FakeBank : Service {
  void read(std::uint16_t first, std::span<std::uint16_t> values) noexcept override {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto number = static_cast<std::uint16_t>(first + i);
      const auto known = written.find(number);
      values[i] = known == written.end() ? static_cast<std::uint16_t>(number & 0xFFU) : known->second;
    }
  }
  bool write(std::uint16_t first, std::span<const std::uint16_t> values) noexcept override {
    if (std::ranges::count(refused, first) != 0) return false;
    for (std::size_t i = 0; i < values.size(); ++i) written[static_cast<std::uint16_t>(first + i)] = values[i];
    commanded = true;
    return true;
  }
  bool is_available() const noexcept override { return available; }
  bool take_command() noexcept override { return std::exchange(commanded, false); }
  void on_command_lost() noexcept override { ++lost; }

  std::map<std::uint16_t, std::uint16_t> written;
  std::vector<std::uint16_t> refused;
  bool available = true;
  bool commanded = false;
  int lost = 0;
};

}  // namespace modbus
