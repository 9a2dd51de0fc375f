#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drive/drive_unit.hpp"
#include "libcanopen/sdo/sdo_view.hpp"

namespace device {

/// Who is told of accesses to parameters over SDO. Called from within the calls of the node.
class WindowListener {
 public:
  virtual ~WindowListener() = default;
  /// No parameter may be written: they are being saved.
  virtual bool is_locked() const noexcept { return false; }
  /// A parameter is about to be read or written.
  virtual void on_parameter_access() noexcept = 0;
  /// Parameter @p number of drive object @p object has been written; what follows from it beyond the drive object
  /// itself has to wait until the node has returned.
  virtual void on_parameter_written(std::uint8_t object, std::uint16_t number) noexcept = 0;
};

/// The parameters of the drive objects as objects 2000h to 470Fh: 2000h plus the number, the sub-index being the
/// parameter's index from 0. The default SDO server shows those of the drive object p8630[0], from index
/// 256·p8630[1] and number 10000·p8630[2] on, and always p8630 itself as 41B6h. Each further server shows its own
/// drive object, 1201h the control unit, and of the other objects only 1000h, 1001h and 1018h.
class ParameterWindow final : public canopen::SdoView {
 public:
  /// Both arguments must outlive this.
  ParameterWindow(drive::DriveUnit& unit, WindowListener& listener) : unit_{unit}, listener_{listener} {}

  canopen::ObjectPlace place_of(std::uint8_t server, std::uint16_t index) const noexcept override;
  canopen::Result<std::size_t> read(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                                    std::span<std::uint8_t, 8> value) noexcept override;
  /// LengthMismatch for a value of another size than the parameter; a value without a size has that of the
  /// parameter.
  canopen::Result<void> write(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                              std::span<const std::uint8_t> value, bool sized) noexcept override;

  /// The parameter that an access means.
  struct Target {
    std::uint8_t object;
    std::uint16_t number;
    std::size_t index;
  };
  /// What an access to @p index, @p sub_index over @p server means now; nothing if that is no parameter. It need
  /// not exist.
  std::optional<Target> parameter_at(std::uint8_t server, std::uint16_t index,
                                     std::uint8_t sub_index) const noexcept;

 private:
  canopen::Result<Target> target(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index) const noexcept;
  std::uint8_t object_of(std::uint8_t server) const noexcept;
  std::uint16_t window(std::size_t index) const noexcept;
  bool is_open() const noexcept;

  drive::DriveUnit& unit_;
  WindowListener& listener_;
};

}  // namespace device
