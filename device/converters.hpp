#pragma once

#include <optional>

#include "device/parameter_owner.hpp"
#include "drive/drive_unit.hpp"

namespace device {

/// The converters of the process data, of any drive object: words made of bits (r8889 of p8880 to p8884, inverted
/// by p8888) and words for their bits (r8894 and r8895 of p8899, inverted by p8898). A converter that is connected
/// to a converter gets 0. Nothing for other parameters.
std::optional<double> converter_value(const drive::DriveUnit& unit, const ParameterPlace& place) noexcept;

}  // namespace device
