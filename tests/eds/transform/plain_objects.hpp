#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include <libcanopen/od/entry_description.hpp>

// clang-format off
/// The object dictionary of plain.eds: one row an entry, in ascending order of index and sub-index.
inline constexpr auto kPlainObjects = [] {
  using enum canopen::DataType;
  using enum canopen::Access;
  return std::to_array<canopen::EntryDescription>({
      {.index = 0x1000, .type = Unsigned32, .access = ReadOnly, .name = "Device type"},
      {.index = 0x1001, .type = Unsigned8, .access = ReadOnly, .pdo_mappable = true, .name = "Error register"},
      {.index = 0x1003, .type = Unsigned8, .access = ReadWrite, .name = "Number of errors"},
      {.index = 0x1003, .sub_index = 1, .type = Unsigned32, .access = ReadOnly, .name = "Newest error"},
      {.index = 0x1005, .type = Unsigned32, .access = ReadWrite, .limit_check = canopen::LimitCheck::Owner, .initial = 128, .name = "COB-ID SYNC"},
      {.index = 0x1014, .type = Unsigned32, .access = ReadWrite, .node_relative = true, .limit_check = canopen::LimitCheck::Owner, .initial = 128, .name = "COB-ID EMCY"},
      {.index = 0x1017, .type = Unsigned16, .access = ReadWrite, .low = 0, .high = 32767, .name = "Heartbeat time"},
      {.index = 0x1018, .type = Unsigned8, .access = Constant, .initial = 4, .name = "Highest sub-index"},
      {.index = 0x1018, .sub_index = 1, .type = Unsigned32, .access = ReadOnly, .initial = 496, .name = "Vendor-ID"},
      {.index = 0x1018, .sub_index = 2, .type = Unsigned32, .access = ReadOnly, .initial = 16, .name = "Product code"},
      {.index = 0x1018, .sub_index = 3, .type = Unsigned32, .access = ReadOnly, .initial = 65538, .name = "Revision number"},
      {.index = 0x1018, .sub_index = 4, .type = Unsigned32, .access = ReadOnly, .name = "Serial number"},
      {.index = 0x1200, .type = Unsigned8, .access = Constant, .initial = 2, .name = "Highest sub-index"},
      {.index = 0x1200, .sub_index = 1, .type = Unsigned32, .access = ReadOnly, .node_relative = true, .limit_check = canopen::LimitCheck::Owner, .initial = 1536, .name = "COB-ID client to server"},
      {.index = 0x1200, .sub_index = 2, .type = Unsigned32, .access = ReadOnly, .node_relative = true, .limit_check = canopen::LimitCheck::Owner, .initial = 1408, .name = "COB-ID server to client"},
      {.index = 0x1400, .type = Unsigned8, .access = Constant, .initial = 2, .name = "Highest sub-index"},
      {.index = 0x1400, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .node_relative = true, .limit_check = canopen::LimitCheck::Owner, .initial = 512, .name = "COB-ID"},
      {.index = 0x1400, .sub_index = 2, .type = Unsigned8, .access = ReadWrite, .initial = 255, .name = "Transmission type"},
      {.index = 0x1600, .type = Unsigned8, .access = ReadWrite, .initial = 2, .name = "Number of mapped objects"},
      {.index = 0x1600, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .initial = 536870928, .name = "First"},
      {.index = 0x1600, .sub_index = 2, .type = Unsigned32, .access = ReadWrite, .initial = 327688, .name = "Second"},
      {.index = 0x1600, .sub_index = 3, .type = Unsigned32, .access = ReadWrite, .name = "Third"},
      {.index = 0x1800, .type = Unsigned8, .access = Constant, .initial = 5, .name = "Highest sub-index"},
      {.index = 0x1800, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .node_relative = true, .limit_check = canopen::LimitCheck::Owner, .initial = 1073742208, .name = "COB-ID"},
      {.index = 0x1800, .sub_index = 2, .type = Unsigned8, .access = ReadWrite, .initial = 254, .name = "Transmission type"},
      {.index = 0x1800, .sub_index = 5, .type = Unsigned16, .access = ReadWrite, .name = "Event timer"},
      {.index = 0x1A00, .type = Unsigned8, .access = ReadWrite, .initial = 2, .name = "Number of mapped objects"},
      {.index = 0x1A00, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .initial = 536936480, .name = "First"},
      {.index = 0x1A00, .sub_index = 2, .type = Unsigned32, .access = ReadWrite, .initial = 537067792, .name = "Second"},
      {.index = 0x2000, .type = Unsigned16, .access = ReadWriteWrite, .pdo_mappable = true, .initial = 1, .low = 0, .high = 1000, .name = "Step"},
      {.index = 0x2001, .type = Unsigned32, .access = ReadOnly, .pdo_mappable = true, .name = "Counter"},
      {.index = 0x2002, .type = Unsigned8, .access = ReadOnly, .initial = 3, .name = "NrOfObjects"},
      {.index = 0x2002, .sub_index = 1, .type = Integer16, .access = ReadWrite, .initial = -1, .low = -100, .high = 100, .name = "Threshold1"},
      {.index = 0x2002, .sub_index = 2, .type = Integer16, .access = ReadWrite, .initial = -1, .low = -100, .high = 100, .name = "Threshold of the middle"},
      {.index = 0x2002, .sub_index = 3, .type = Integer16, .access = ReadWrite, .initial = -1, .low = -100, .high = 100, .name = "Threshold3"},
      {.index = 0x2003, .type = Unsigned8, .access = Constant, .initial = 2, .name = "Highest sub-index"},
      {.index = 0x2003, .sub_index = 1, .type = Integer16, .access = ReadOnly, .pdo_mappable = true, .name = "Sum"},
      {.index = 0x2003, .sub_index = 2, .type = Integer16, .access = ReadOnly, .pdo_mappable = true, .name = "Difference"},
      {.index = 0x2004, .type = Domain, .access = ReadWrite, .name = "Notes"},
  });
}();
// clang-format on
