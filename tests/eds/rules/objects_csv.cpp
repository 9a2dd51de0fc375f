#include "tests/eds/rules/objects_csv.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/eds/rules/eds_reader.hpp"

namespace eds_test {
namespace {

constexpr std::string_view kColumns =
    "scope,index,sub,object,type,access,pdo_mappable,default,low,high,obj_flags,name";

std::vector<std::string> split(std::string line) {
  std::vector<std::string> cells;
  line += ',';
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t comma = line.find(',', at);
    cells.push_back(line.substr(at, comma - at));
    at = comma + 1;
  }
  return cells;
}

}  // namespace

std::vector<Fact> read_facts(const std::string& file) {
  std::istringstream text{read_file(std::string{SOURCE_FOLDER} + "/tests/eds/data/" + file)};
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, kColumns);
  const std::vector<std::string> names = split(line);
  std::vector<Fact> facts;
  while (std::getline(text, line)) {
    const std::vector<std::string> cells = split(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    Fact& fact = facts.emplace_back();
    for (std::size_t n = 0; n < names.size() && n < cells.size(); ++n) fact[names[n]] = cells[n];
  }
  return facts;
}

std::uint16_t index_of(const Fact& fact) {
  return static_cast<std::uint16_t>(std::stoul(fact.at("index"), nullptr, 16));
}

std::uint8_t sub_index_of(const Fact& fact) {
  return static_cast<std::uint8_t>(std::stoul(fact.at("sub"), nullptr, 16));
}

bool is_head(const Fact& fact) {
  return fact.at("sub").empty();
}

}  // namespace eds_test
