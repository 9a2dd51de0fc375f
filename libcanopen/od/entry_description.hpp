#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "libcanopen/od/data_type.hpp"

namespace canopen {

/// Access attribute of an entry (CiA 306, AccessType).
enum class Access : std::uint8_t {
  ReadOnly,        ///< ro
  WriteOnly,       ///< wo
  ReadWrite,       ///< rw
  ReadWriteRead,   ///< rwr: read and write, mappable into TPDOs
  ReadWriteWrite,  ///< rww: read and write, mappable into RPDOs
  Constant,        ///< const
};

/// Who judges whether a value is within range.
enum class LimitCheck : std::uint8_t {
  Table,  ///< the dictionary, by `low` and `high`
  Owner,  ///< the owner of the entry; the limits are only stated (COB-IDs)
};

/// One row of an object dictionary: what CiA 306 says of one entry (index and sub-index).
/// Numbers are two's complement in 64 bits; REAL32 and REAL64 are given by their bit pattern.
struct EntryDescription {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  DataType type = DataType::Unsigned8;
  Access access = Access::ReadOnly;
  bool pdo_mappable = false;
  bool node_relative = false;  ///< the node-ID is added to `initial` ($NODEID+...)
  LimitCheck limit_check = LimitCheck::Table;
  std::int64_t initial = 0;           ///< value after power-on, before node-ID and stored values
  std::optional<std::int64_t> low{};  ///< smallest value that may be written
  std::optional<std::int64_t> high{};
  std::string_view text{};     ///< initial value of a string type
  std::string_view name{};     ///< ParameterName in the EDS
  std::uint16_t capacity = 0;  ///< longest value of a writable string type, in bytes
};

}  // namespace canopen
