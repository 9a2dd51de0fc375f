#pragma once

#include <string>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// The catalogue as a reference page (Markdown): a table an object group.
[[nodiscard]] std::string write_reference(const Catalogue& catalogue);

}  // namespace eds
