#pragma once

#include "tests/eds/rules/object_rules.hpp"

namespace eds_test {

/// Checks the modules that @p file supports, beside the @p device; the names of their sections are added to
/// @p names. Returns the objects of the device and of all its modules.
ObjectSet check_modules(const EdsFile& file, const ObjectSet& device, std::set<std::string>& names,
                        Breaches& breaches);

}  // namespace eds_test
