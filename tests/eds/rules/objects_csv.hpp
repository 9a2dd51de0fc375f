#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace eds_test {

/// One row of data/objects.csv, what is known of the real unit, or of data/cia402-objects.csv, what a CiA 402
/// device has to be: cells by the names of the columns.
using Fact = std::map<std::string, std::string>;

/// Every row of @p file in data/, in order; a test fails where it has other columns.
std::vector<Fact> read_facts(const std::string& file = "objects.csv");

/// Index and, in rows of entries, sub-index of @p fact.
std::uint16_t index_of(const Fact& fact);
std::uint8_t sub_index_of(const Fact& fact);

/// True for rows of arrays and records, which have no value of their own.
bool is_head(const Fact& fact);

}  // namespace eds_test
