#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace control {
namespace {

std::string text_of(const char* path) {
  std::ifstream file{path};
  return {std::istreambuf_iterator<char>{file}, {}};
}

TEST(ControlPage, IsUpToDate) {
  const std::string made = text_of(METHODS_PAGE);
  ASSERT_NE(made, "");

  EXPECT_NE(text_of(SOURCE_FOLDER "/docs/reference/control.md").find(": begin -->\n" + made + "<!-- "),
            std::string::npos)
      << "docs/reference/control.md differs from control/protocol/: cmake --build BUILD --target update_generated";
}

}  // namespace
}  // namespace control
