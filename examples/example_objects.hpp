#pragma once

#include <array>

#include <libcanopen/od/entry_description.hpp>

/// The object dictionary of the example: one row an entry, in ascending order of index and sub-index.
inline constexpr auto kObjects = [] {
  using enum canopen::DataType;
  using enum canopen::Access;
  return std::to_array<canopen::EntryDescription>({
      {.index = 0x1000, .type = Unsigned32},                                        // device type: no profile
      {.index = 0x1001},                                                            // error register
      {.index = 0x1005, .type = Unsigned32, .access = ReadWrite, .initial = 0x80},  // identifier of SYNC
      {.index = 0x1017, .type = Unsigned16, .access = ReadWrite},                   // heartbeat time, ms
      // identity: vendor, product
      {.index = 0x1018, .sub_index = 0, .access = Constant, .initial = 2},
      {.index = 0x1018, .sub_index = 1, .type = Unsigned32},
      {.index = 0x1018, .sub_index = 2, .type = Unsigned32, .initial = 1},
      // SDO server: identifiers of request and response
      {.index = 0x1200, .sub_index = 0, .access = Constant, .initial = 2},
      {.index = 0x1200, .sub_index = 1, .type = Unsigned32, .node_relative = true, .initial = 0x600},
      {.index = 0x1200, .sub_index = 2, .type = Unsigned32, .node_relative = true, .initial = 0x580},
      // RPDO 1, identifier 200h + node-ID, taken at once (type 255): the step
      {.index = 0x1400, .sub_index = 0, .access = Constant, .initial = 2},
      {.index = 0x1400,
       .sub_index = 1,
       .type = Unsigned32,
       .access = ReadWrite,
       .node_relative = true,
       .initial = 0x200},
      {.index = 0x1400, .sub_index = 2, .access = ReadWrite, .initial = 255},
      {.index = 0x1600, .sub_index = 0, .access = ReadWrite, .initial = 1, .low = 0, .high = 1},
      {.index = 0x1600, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .initial = 0x20020010},
      // TPDO 1, identifier 180h + node-ID, sent when a value changes (type 255): the counter
      {.index = 0x1800, .sub_index = 0, .access = Constant, .initial = 5},
      {.index = 0x1800,
       .sub_index = 1,
       .type = Unsigned32,
       .access = ReadWrite,
       .node_relative = true,
       .initial = 0x40000180},
      {.index = 0x1800, .sub_index = 2, .access = ReadWrite, .initial = 255},
      {.index = 0x1800, .sub_index = 5, .type = Unsigned16, .access = ReadWrite},  // event timer, ms
      {.index = 0x1A00, .sub_index = 0, .access = ReadWrite, .initial = 1, .low = 0, .high = 1},
      {.index = 0x1A00, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .initial = 0x20000020},
      // the application: a counter, and the step by which each RPDO advances it
      {.index = 0x2000, .type = Unsigned32, .pdo_mappable = true},
      {.index = 0x2001, .type = Domain, .access = ReadWrite},  // a document of any size
      {.index = 0x2002, .type = Unsigned16, .access = ReadWriteWrite, .pdo_mappable = true, .initial = 1},
  });
}();
