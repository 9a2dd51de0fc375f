#pragma once

#include <cstdint>
#include <span>

#include "modbus/register_map.hpp"
#include "modbus/service.hpp"
#include "modbus/unit_face.hpp"
#include "profidrive/interface/interface.hpp"
#include "unit/runner.hpp"

namespace modbus {

/// The holding registers of a drive unit: see register_map(). The time of an access is what the runner was told.
class UnitRegisters final : public Service {
 public:
  /// All of the same unit; they outlive this.
  UnitRegisters(unit::Runner& runner, profidrive::Interface& interface, UnitFace& face) noexcept
      : runner_{runner}, interface_{interface}, face_{face} {}

  // RegisterBank
  void read(std::uint16_t first, std::span<std::uint16_t> values) noexcept override;
  /// Nothing is written if one of the registers cannot be; parameters are written one by one up to the first that
  /// is refused.
  [[nodiscard]] bool write(std::uint16_t first, std::span<const std::uint16_t> values) noexcept override;
  // Service
  bool is_available() const noexcept override { return runner_.is_on() && face_.target() != nullptr; }
  bool take_command() noexcept override;
  void on_command_lost() noexcept override { interface_.on_connection_lost(commanded_); }

 private:
  /// A register with its row.
  struct Place {
    const RegisterRow& row;
    std::uint16_t number;

    std::uint16_t offset() const noexcept { return static_cast<std::uint16_t>(number - row.first); }
  };

  std::uint16_t read(const drive::DriveObject& target, const Place& place) const noexcept;
  bool refuse(drive::RefusalReason reason) noexcept;
  bool exists(const drive::DriveObject& target, const Place& place) const noexcept;
  bool is_writable(const drive::DriveObject& target, std::uint16_t number) noexcept;
  bool write_parameters(std::uint8_t target, std::uint16_t first, std::span<const std::uint16_t> values) noexcept;

  unit::Runner& runner_;
  profidrive::Interface& interface_;
  UnitFace& face_;
  std::uint16_t refusal_code_ = 0;  ///< of the last refused access
  std::uint8_t commanded_ = 0;      ///< the drive object that process data was last written to
  bool has_command_ = false;
};

}  // namespace modbus
