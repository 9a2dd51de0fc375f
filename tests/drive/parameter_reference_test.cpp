#include "drive/reference/parameter_reference.hpp"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace drive {
namespace {

TEST(ParameterReference, IsCheckedInAsTheTablesGiveIt) {
  std::ifstream file{std::string{SOURCE_FOLDER} + "/docs/reference/parameters.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};

  EXPECT_TRUE(page == parameter_reference())
      << "docs/reference/parameters.md is not what the tables give; refresh it with: cmake --build BUILD --target "
         "update_parameter_reference";
}

}  // namespace
}  // namespace drive
