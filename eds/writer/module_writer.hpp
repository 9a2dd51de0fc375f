#pragma once

#include "eds/catalogue/catalogue.hpp"
#include "eds/writer/eds_lines.hpp"

namespace eds {

/// The modules of the unit (CiA 306): a type for each axis 1..kMostAxes as servo and as vector axis, because the
/// objects of an axis depend on its place. A module brings the objects of its axis and its entry of the module
/// list 1027h, whose value is the order code.
void write_modules(Lines& lines, const Catalogue& catalogue);

/// Says that the unit has no modules to choose from: what is there is listed.
void write_no_modules(Lines& lines);

}  // namespace eds
