#include "profidrive/reference/telegram_reference.hpp"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace profidrive {
namespace {

TEST(TelegramReference, IsCheckedInAsTheTablesGiveIt) {
  std::ifstream file{std::string{SOURCE_FOLDER} + "/docs/reference/telegrams.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};

  EXPECT_TRUE(page == telegram_reference())
      << "docs/reference/telegrams.md is not what the tables give; refresh it with: cmake --build BUILD --target "
         "update_telegram_reference";
}

}  // namespace
}  // namespace profidrive
