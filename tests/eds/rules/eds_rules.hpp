#pragma once

#include "tests/eds/rules/object_rules.hpp"

namespace eds_test {

/// What breaks CiA 306 in @p file: sections, counts, types, limits, mappings and modules. Written without the code
/// under test.
Breaches breaches_of(const EdsFile& file);

/// Checks the list of indices in the section @p name, counted under @p count_key, against the @p listed ones.
void check_index_list(const EdsFile& file, const std::string& name, const std::string& count_key,
                      const std::set<unsigned>& listed, Breaches& breaches);

}  // namespace eds_test
