#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace modbus {

/// Numbers of the first and of the last holding register; the address in a frame counts from the first.
inline constexpr std::uint16_t kFirstRegister = 40001, kLastRegister = 40722;
inline constexpr std::size_t kRegisters = kLastRegister - kFirstRegister + 1;

/// The holding registers of a server.
class RegisterBank {
 public:
  virtual ~RegisterBank() = default;
  /// The values of the registers from number @p first on, all of which exist; each of them has one.
  virtual void read(std::uint16_t first, std::span<std::uint16_t> values) noexcept = 0;
  /// Writes the registers from number @p first on, all of which exist; false if one of them was refused.
  [[nodiscard]] virtual bool write(std::uint16_t first, std::span<const std::uint16_t> values) noexcept = 0;
};

}  // namespace modbus
