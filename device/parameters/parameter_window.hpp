#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drive/access/parameter_access.hpp"
#include "libcanopen/sdo/sdo_view.hpp"

namespace device {

/// The parameters of the drive objects as objects 2000h to 470Fh: 2000h plus the number, the sub-index being the
/// parameter's index from 0. The default SDO server shows those of the drive object p8630[0], from index
/// 256·p8630[1] and number 10000·p8630[2] on, and always p8630 itself as 41B6h. Each further server shows its own
/// drive object, 1201h the control unit, and of the other objects only 1000h, 1001h and 1018h.
class ParameterWindow final : public canopen::SdoView {
 public:
  /// Both arguments must outlive this.
  ParameterWindow(drive::DriveUnit& unit, drive::AccessListener& listener) noexcept
      : unit_{unit}, access_{unit, listener} {}

  canopen::ObjectPlace place_of(std::uint8_t server, std::uint16_t index) const noexcept override;
  canopen::Result<std::size_t> read(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                                    std::span<std::uint8_t, 8> value) noexcept override;
  /// LengthMismatch for a value of another size than the parameter; a value without a size has that of the
  /// parameter.
  canopen::Result<void> write(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                              std::span<const std::uint8_t> value, bool sized) noexcept override;

  /// The parameter that an access means.
  using Target = drive::ParameterAddress;
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
  drive::ParameterAccess access_;
};

}  // namespace device
