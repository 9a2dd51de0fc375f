#pragma once

#include <string>

#include "eds/sheet/data_sheet.hpp"

namespace eds {

/// What a file says, for reading: the device, then a line for each object and each entry with type, access,
/// mapping, name, default or value, and limits; then the modules.
[[nodiscard]] std::string write_tree(const DataSheet& sheet);

/// The word for an object code: "VAR", "ARRAY"; "?" for a number that is none.
[[nodiscard]] std::string_view word_of(ObjectCode code) noexcept;

}  // namespace eds
