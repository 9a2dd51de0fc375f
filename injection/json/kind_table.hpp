#pragma once

#include <span>
#include <string>

#include "injection/language/fault.hpp"

namespace injection {

/// @p kinds as a table in Markdown: name, what happens, what it hits, arguments.
std::string kind_table(std::span<const Kind> kinds);
/// The arguments of @p kinds likewise: key, what it may be, what it says.
std::string argument_table(std::span<const Kind> kinds);
/// The keys that say when likewise.
std::string when_table();

}  // namespace injection
