#pragma once

#include <string>

namespace control {

/// The table of the methods as docs/control.md has it.
[[nodiscard]] std::string method_table();

}  // namespace control
