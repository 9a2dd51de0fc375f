#pragma once

#include <string>
#include <string_view>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// The catalogue, which lies at @p source in the project, as a reference page (Markdown): a table an object group.
[[nodiscard]] std::string write_reference(const Catalogue& catalogue, std::string_view source);

}  // namespace eds
