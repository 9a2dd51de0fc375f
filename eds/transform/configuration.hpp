#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "eds/document/document.hpp"

namespace eds {

/// A value that a DCF gives to an entry.
struct Setting {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::string value{};
};

/// Reads "6083=1000", "6083h=1000", "0x1018:1=5", "1018h:01=5" or "1018sub1=5": index and sub-index are
/// hexadecimal, the value is as an EDS writes it. Nothing for anything else.
[[nodiscard]] std::optional<Setting> parse_setting(std::string_view text);

/// What section DeviceComissioning of a DCF says.
struct NodeSettings {
  unsigned node_id = 0;     ///< 1 to 127
  unsigned bit_rate = 0;    ///< kbit/s; 0: the highest one that the device supports
  std::string node_name{};  ///< empty: as the product
  unsigned net_number = 1;
  std::string network_name{};
  bool manager = false;
};

/// The DCF of one node, made from @p eds: the node, and a ParameterValue for each of @p settings, of which the
/// last one counts. FileInfo tells the EDS it was made from. A finding for every setting that cannot be, which is
/// left out.
[[nodiscard]] Document configure(const Document& eds, const NodeSettings& node, std::span<const Setting> settings,
                                 Findings& findings);

}  // namespace eds
