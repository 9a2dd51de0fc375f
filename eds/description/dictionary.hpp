#pragma once

#include "eds/description/description.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace eds {

/// What an EDS of @p dictionary would say of its entries, for its node-ID; of the device, nothing. The
/// communication objects (1000h to 1FFFh) begin with the values that they have now.
[[nodiscard]] Description describe(const canopen::Dictionary& dictionary);

}  // namespace eds
