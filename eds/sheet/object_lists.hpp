#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// What an index says of an object.
namespace eds {

/// A list of the device's objects, and which ones belong to it (CiA 306, 4.5).
struct ObjectList {
  std::string_view section;
  bool (*contains)(std::uint16_t index);
};

/// True for the objects without which there is no CANopen device.
[[nodiscard]] constexpr bool is_mandatory(std::uint16_t index) noexcept {
  return index == 0x1000 || index == 0x1001 || index == 0x1018;
}
/// True for the area of the manufacturer.
[[nodiscard]] constexpr bool is_manufacturer(std::uint16_t index) noexcept {
  return index >= 0x2000 && index < 0x6000;
}

/// The lists in the order of an EDS; every object belongs to one.
inline constexpr std::array kObjectLists{
    ObjectList{"MandatoryObjects", is_mandatory},
    ObjectList{"OptionalObjects",
               [](std::uint16_t index) { return !is_mandatory(index) && !is_manufacturer(index); }},
    ObjectList{"ManufacturerObjects", is_manufacturer},
};

/// The section that lists @p index.
[[nodiscard]] constexpr std::string_view list_of(std::uint16_t index) noexcept {
  for (const ObjectList& list : kObjectLists)
    if (list.contains(index)) return list.section;
  return {};
}

/// True for PDO mapping parameters, whose entries from sub-index 1 name the mapped objects.
[[nodiscard]] constexpr bool is_mapping_parameter(std::uint16_t index) noexcept {
  return (index >= 0x1600 && index < 0x1800) || (index >= 0x1A00 && index < 0x1C00);
}

/// Entries that hold COB-IDs (CiA 301, 7.5.2).
struct CobIdObjects {
  std::uint16_t first;
  std::uint16_t last;
  std::uint8_t first_sub;
  std::uint8_t last_sub;
  bool may_be_restricted;  ///< the default SDO channel, whose COB-IDs are fixed
  bool bit31_is_invalid;   ///< else it means something else

  /// True when the entry is one of them.
  [[nodiscard]] constexpr bool contains(std::uint16_t index, std::uint8_t sub_index) const noexcept {
    return index >= first && index <= last && sub_index >= first_sub && sub_index <= last_sub;
  }
};
inline constexpr std::array kCobIdObjects{
    CobIdObjects{0x1005, 0x1005, 0, 0, false, false}, CobIdObjects{0x1012, 0x1012, 0, 0, false, false},
    CobIdObjects{0x1014, 0x1014, 0, 0, false, true},  CobIdObjects{0x1200, 0x1200, 1, 2, true, true},
    CobIdObjects{0x1201, 0x127F, 1, 2, false, true},  CobIdObjects{0x1280, 0x12FF, 1, 2, false, true},
    CobIdObjects{0x1400, 0x15FF, 1, 1, false, true},  CobIdObjects{0x1800, 0x19FF, 1, 1, false, true},
};

/// The row of the entry, or null where it holds no COB-ID.
[[nodiscard]] constexpr const CobIdObjects* find_cob_id(std::uint16_t index, std::uint8_t sub_index) noexcept {
  for (const CobIdObjects& row : kCobIdObjects)
    if (row.contains(index, sub_index)) return &row;
  return nullptr;
}

}  // namespace eds
