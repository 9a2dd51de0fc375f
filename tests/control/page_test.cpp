#include "control/page.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace control {
namespace {

/// The table is written down as this test prints it where it fails.
TEST(ControlPage, HasTheTableOfTheMethodsAsTheirRowsSayIt) {
  std::ifstream file{SOURCE_FOLDER "/docs/control.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t begin = page.find("| method |");
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = page.find("\n\n", begin);
  EXPECT_EQ(page.substr(begin, end + 1 - begin), method_table()) << method_table();
}

}  // namespace
}  // namespace control
