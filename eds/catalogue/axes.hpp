#pragma once

#include <span>
#include <vector>

#include "eds/catalogue/catalogue.hpp"

/// The offset rule: what the objects of axis 1 are on the other axes, and on axes of the other type.
namespace eds {

/// Object of the module list (CiA 301), an entry for each axis.
inline constexpr std::uint16_t kModuleList = 0x1027;

/// The objects of axis @p axis (1..kMostAxes) of type @p type, ascending by index.
[[nodiscard]] std::vector<Object> axis_objects(const Catalogue& catalogue, unsigned axis, DriveType type);

/// The module list of a unit with @p axes (1..kMostAxes): what @p object says of all, cut to those that exist.
[[nodiscard]] Object module_list(const Object& object, std::span<const DriveType> axes);

/// Every object of a unit with @p axes (1..kMostAxes), ascending by index.
[[nodiscard]] std::vector<Object> unit_objects(const Catalogue& catalogue, std::span<const DriveType> axes);

/// The parameter objects that a drive object lists, ascending by index; for the unit as a whole none.
[[nodiscard]] std::vector<Object> parameter_objects(const Catalogue& catalogue, FileContent drive_object);

/// Whether a drive object of @p scope lists the parameter object @p index.
[[nodiscard]] bool lists_parameter(const Catalogue& catalogue, Scope scope, std::uint16_t index);

}  // namespace eds
