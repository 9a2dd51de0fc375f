#pragma once

#include <map>
#include <string>
#include <vector>

namespace drive_test {

/// One line of a table by its column names.
using CsvRow = std::map<std::string, std::string>;

/// The lines of tests/drive/data/@p file; cells may stand in quotes.
std::vector<CsvRow> read_csv(const std::string& file);

}  // namespace drive_test
