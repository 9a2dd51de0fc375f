#pragma once

#include <string>
#include <vector>

namespace os {

/// The names of what is in @p folder, without "." and ".."; of one that cannot be read, what could be.
/// std::bad_alloc, where std::filesystem would end the program.
std::vector<std::string> names_in(const std::string& folder);

}  // namespace os
