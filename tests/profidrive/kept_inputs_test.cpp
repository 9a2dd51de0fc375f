/// What the fuzzer of records has found worth keeping (tests/fuzz/records/corpus).
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "tests/profidrive/fuzzed_unit.hpp"

namespace profidrive {
namespace {

TEST(KeptInputs, AreAnsweredWellFormed) {
  FuzzedUnit unit;
  std::size_t played = 0;

  for (const auto& file : std::filesystem::directory_iterator{SOURCE_FOLDER "/tests/fuzz/records/corpus"}) {
    std::ifstream stream{file.path(), std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{stream}, {}};
    const std::vector<std::uint8_t> input{text.begin(), text.end()};
    EXPECT_EQ(unit.play(input), "") << file.path();
    ++played;
  }

  EXPECT_GT(played, 40U);
}

}  // namespace
}  // namespace profidrive
