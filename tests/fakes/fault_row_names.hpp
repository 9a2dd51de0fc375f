#pragma once

#include <ostream>

#include "drive/messages/fault_table.hpp"

namespace drive {

/// How GoogleTest names a row of the fault table.
inline void PrintTo(const FaultRow& row,
                    std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << fault_text(row);
}

}  // namespace drive
