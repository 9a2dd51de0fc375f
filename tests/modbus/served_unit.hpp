#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "modbus/connection.hpp"
#include "modbus/unit_registers.hpp"
#include "tests/unit/shelf.hpp"

namespace modbus {

/// A drive unit behind the registers, switched on and at rest. Its control unit is drive object 1, its axes
/// follow. Time is told.
class ServedUnit {
 public:
  explicit ServedUnit(const unit::Configuration& configuration = one_axis());
  static unit::Configuration one_axis() { return {.drive = {.axes = {{}}, .node_id = 5}}; }

  /// What one connection answers to @p frames, hexadecimal, of any number.
  std::string exchange(std::string_view frames);
  /// The value of register @p number, or -1 with an exception.
  int read(std::uint16_t number);
  /// Writes register @p number; the exception, or 0.
  int write(std::uint16_t number, std::uint16_t value);
  /// The time goes on in steps of a cycle.
  void passes(unit::Duration time);
  /// Writes a parameter as a master beside does.
  void set(std::uint8_t object, std::uint16_t number, double value, std::size_t index = 0);
  double value(std::uint8_t object, std::uint16_t number) const;

  unit::Shelf shelf;
  unit::Runner runner;
  profidrive::Interface interface { runner };
  UnitFace face{runner};
  UnitRegisters registers{runner, interface, face};
  Counters counters{};
  Connection connection{registers, counters};
};

}  // namespace modbus
