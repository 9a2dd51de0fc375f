#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "drive/sequence_control/state_machine.hpp"

namespace device {

/// What an axis has beside those of the drive unit, where masters see a positioning axis of CiA 402.
struct ProfileView {
  std::string_view mode;         ///< 6061h in words
  bool is_homed = false;         ///< 6041h bit 15
  std::int32_t position = 0;     ///< 6064h, position units
  std::uint32_t inputs = 0;      ///< 60FDh
  std::uint32_t outputs = 0;     ///< 60FEh, as far as its mask lets them through
  std::uint16_t error_code = 0;  ///< 603Fh
};

/// An axis as the masters of its node see it.
struct AxisView {
  drive::State state{};
  std::uint16_t controlword = 0;
  std::uint16_t statusword = 0;
  std::int64_t position = 0;  ///< 6063h, encoder increments
  std::optional<ProfileView> profile{};
};

}  // namespace device
