#pragma once

#include <span>

#include "libcanopen/od/entry_description.hpp"
#include "tests/eds/rules/eds_reader.hpp"

namespace eds_test {

/// Expects that @p file says of every one of @p rows what the row says: type, access, mapping, name, limits, and
/// the initial value where the EDS states one.
void expect_rows_in_eds(std::span<const canopen::EntryDescription> rows, const EdsFile& file);

/// Entries that @p file has: variables and sub-indices.
std::size_t count_entries(const EdsFile& file);

}  // namespace eds_test
