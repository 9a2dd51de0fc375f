#pragma once

#include <cstdint>
#include <string>

#include "daemon/control/arguments.hpp"

namespace axisd {

/// Index and sub-index of an object.
struct ObjectAddress {
  std::uint16_t index;
  std::uint8_t sub_index;
};

/// The object that keys "index" and "sub_index" (0 if absent) of @p params name. The index is a number, or a text
/// in hexadecimal ("6040", "6040h", "0x6040"), with the sub-index behind it if that is not a key ("1018:04").
Taken<ObjectAddress> object_address(const nlohmann::json& params);

/// "1018h:04".
std::string address_text(const ObjectAddress& address);

}  // namespace axisd
