#include <fstream>
#include <iterator>
#include <string>

#include "injection/json/kind_table.hpp"
#include "injection/kinds/unit_kinds.hpp"
#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

TEST(FaultPage, IsUpToDate) {
  std::ifstream file{SOURCE_FOLDER "/docs/reference/faults.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  for (const std::string& table : {kind_table(unit_kinds()), argument_table(unit_kinds()), when_table()})
    EXPECT_NE(page.find(table), std::string::npos)
        << "docs/reference/faults.md differs from injection/: cmake --build BUILD --target update_generated";
}

}  // namespace
}  // namespace injection
