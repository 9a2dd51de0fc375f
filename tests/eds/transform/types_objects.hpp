#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include <libcanopen/od/entry_description.hpp>

// clang-format off
/// The object dictionary of types.eds: one row an entry, in ascending order of index and sub-index.
inline constexpr auto kTypesObjects = [] {
  using enum canopen::DataType;
  using enum canopen::Access;
  return std::to_array<canopen::EntryDescription>({
      {.index = 0x1000, .type = Unsigned32, .access = ReadOnly, .name = "Device type"},
      {.index = 0x1001, .type = Unsigned8, .access = ReadOnly, .name = "Error register"},
      {.index = 0x1018, .type = Unsigned8, .access = Constant, .initial = 1, .name = "Count"},
      {.index = 0x1018, .sub_index = 1, .type = Unsigned32, .access = ReadOnly, .initial = 496, .name = "Vendor-ID"},
      {.index = 0x2001, .type = Boolean, .access = ReadWrite, .initial = 1, .name = "Type 01"},
      {.index = 0x2002, .type = Integer8, .access = ReadWrite, .initial = -128, .low = -128, .high = 127, .name = "Type 02"},
      {.index = 0x2003, .type = Integer16, .access = ReadWrite, .initial = -32768, .name = "Type 03"},
      {.index = 0x2004, .type = Integer32, .access = ReadWrite, .initial = -2147483648, .name = "Type 04"},
      {.index = 0x2005, .type = Unsigned8, .access = ReadWrite, .initial = 255, .name = "Type 05"},
      {.index = 0x2006, .type = Unsigned16, .access = ReadWrite, .initial = 65535, .name = "Type 06"},
      {.index = 0x2007, .type = Unsigned32, .access = ReadWrite, .initial = 4294967295, .name = "Type 07"},
      {.index = 0x2008, .type = Real32, .access = ReadWrite, .initial = 3300622336, .low = 3304718336, .high = 1148846080, .name = "Type 08"},
      {.index = 0x2009, .type = VisibleString, .access = ReadWrite, .text = std::string_view{"any text; with anything=in it", 29}, .name = "Type 09", .capacity = 64},
      {.index = 0x200A, .type = OctetString, .access = ReadWrite, .text = std::string_view{"\001\002\377", 3}, .name = "Type 0A", .capacity = 64},
      {.index = 0x200B, .type = UnicodeString, .access = ReadWrite, .text = std::string_view{"text", 4}, .name = "Type 0B", .capacity = 64},
      {.index = 0x200C, .type = TimeOfDay, .access = ReadWrite, .name = "Type 0C"},
      {.index = 0x200D, .type = TimeDifference, .access = ReadWrite, .name = "Type 0D"},
      {.index = 0x200F, .type = Domain, .access = ReadWrite, .name = "Type 0F"},
      {.index = 0x2010, .type = Integer24, .access = ReadWrite, .initial = -8388608, .name = "Type 10"},
      {.index = 0x2011, .type = Real64, .access = ReadWrite, .initial = 9094988921128908188, .name = "Type 11"},
      {.index = 0x2012, .type = Integer40, .access = ReadWrite, .initial = -549755813888, .name = "Type 12"},
      {.index = 0x2013, .type = Integer48, .access = ReadWrite, .name = "Type 13"},
      {.index = 0x2014, .type = Integer56, .access = ReadWrite, .name = "Type 14"},
      {.index = 0x2015, .type = Integer64, .access = ReadWrite, .initial = std::numeric_limits<std::int64_t>::min(), .name = "Type 15"},
      {.index = 0x2016, .type = Unsigned24, .access = ReadWrite, .initial = 16777215, .name = "Type 16"},
      {.index = 0x2018, .type = Unsigned40, .access = ReadWrite, .initial = 1099511627775, .name = "Type 18"},
      {.index = 0x2019, .type = Unsigned48, .access = ReadWrite, .name = "Type 19"},
      {.index = 0x201A, .type = Unsigned56, .access = ReadWrite, .name = "Type 1A"},
      {.index = 0x201B, .type = Unsigned64, .access = ReadWrite, .initial = -1, .name = "Type 1B"},
  });
}();
// clang-format on
