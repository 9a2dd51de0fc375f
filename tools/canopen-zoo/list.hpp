#pragma once

#include <cstdint>
#include <string>

namespace zoo {

/// How the slaves are listed.
enum class ListForm : std::uint8_t {
  Text,      ///< a line each
  Json,      ///< an array of {name, what, found_by}
  Markdown,  ///< a page of documentation
};

/// Every slave that can be run: its name, what is wrong, the checks of canopen-check that find it.
[[nodiscard]] std::string list_of_residents(ListForm form);

}  // namespace zoo
