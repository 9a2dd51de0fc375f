#pragma once

#include <cstddef>
#include <cstdint>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// The two identifiers of an SDO server, by their sub-indices (CiA 301, 7.5.2.33).
enum class SdoWay : std::uint8_t { Request = 1, Response = 2 };

/// The identifier of server @p number (0: that of 1200h) in @p dictionary of the node @p node_id; 0 if it has
/// none. The default server has no object that says it in every unit: the pre-defined connection set does.
inline canopen::Identifier sdo_identifier(const canopen::Dictionary& dictionary, std::uint8_t node_id,
                                          std::size_t number, SdoWay way) noexcept {
  const auto index = static_cast<std::uint16_t>(canopen::object::kSdoServer + number);
  if (const auto cob_id = dictionary.stored(index, static_cast<std::uint8_t>(way)))
    return canopen::valid_identifier(static_cast<std::uint32_t>(*cob_id));
  const auto base =
      way == SdoWay::Request ? canopen::function_code::kSdoRequest : canopen::function_code::kSdoResponse;
  return number == 0 ? base + node_id : 0;
}

}  // namespace device
