#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "injection/json/kind_table.hpp"
#include "injection/kinds/bus_kinds.hpp"
#include "injection/kinds/unit_kinds.hpp"

namespace {

constexpr std::string_view kBegin = "<!-- made from injection/: begin -->\n";
constexpr std::string_view kEnd = "<!-- made from injection/: end -->";

std::string tables_of(std::span<const injection::Kind> kinds) {
  return injection::kind_table(kinds) + '\n' + injection::argument_table(kinds);
}

/// Page @p path gets @p tables between its marks; false if it has none.
bool update(const std::string& path, std::string_view tables) {
  std::ifstream file{path};
  std::string page{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos) return false;
  const std::size_t from = begin + kBegin.size();
  page.replace(from, end - from, tables);
  return static_cast<bool>(std::ofstream{path} << page);
}

}  // namespace

/// write_fault_page FOLDER: puts the tables of the kinds of faults between the marks of the pages in FOLDER.
int main(int argc, char** argv) {
  const std::string folder = argc == 2 ? argv[1] : "";
  if (!folder.empty() &&
      update(folder + "/faults.md", tables_of(injection::unit_kinds()) + '\n' + injection::when_table()) &&
      update(folder + "/bus-faults.md", tables_of(injection::bus_kinds())))
    return 0;
  std::cerr << "write_fault_page: expected a folder whose pages have marks\n";
  return 2;
}
