#pragma once

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// Checks what one row alone cannot show: structure of arrays and records, mandatory objects, PDO mappings,
/// parameters, and what the other axes make of the objects of axis 1.
/// Throws CatalogueError, whose message names the object or entry and what was expected.
void check_objects(const Catalogue& catalogue);

}  // namespace eds
