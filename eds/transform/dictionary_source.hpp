#pragma once

#include <string>
#include <string_view>

#include "eds/sheet/data_sheet.hpp"

namespace eds {

/// How a dictionary is written as C++.
struct SourceOptions {
  std::string_view table = "kObjects";  ///< name of the table
  std::string_view origin;              ///< file that the table was made from, for its comment
  unsigned text_capacity = 64;          ///< bytes of a writable string, about which an EDS says nothing
};

/// A C++ header with the table of @p sheet from which canopen::Dictionary is built: one row an entry, in order. A
/// finding for each entry whose type libcanopen does not know, which is left out; limits relative to the node-ID
/// are left out too.
[[nodiscard]] std::string write_dictionary(const DataSheet& sheet, const SourceOptions& options,
                                           Findings& findings);

}  // namespace eds
