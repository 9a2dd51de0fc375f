#include <string>

#include <gtest/gtest.h>

#include "bench/operations/operation.hpp"
#include "tests/fakes/allocation_counter.hpp"

namespace {

/// Everything that is measured is on the hot path, whole cycles of eight turning axes included.
class MeasuredOperation : public testing::TestWithParam<bench::OperationRow> {};

TEST_P(MeasuredOperation, AllocatesNothing) {
  constexpr std::size_t kTimes = 250;
  const auto operation = GetParam().make();
  const std::uint64_t before = fakes::allocations();

  operation->run(kTimes);

  EXPECT_EQ(fakes::allocations(), before);
}

TEST(AllocationCounter, Counts) {
  const std::uint64_t before = fakes::allocations();
  const std::string text(100, 'x');
  EXPECT_GT(fakes::allocations(), before) << text;
}

INSTANTIATE_TEST_SUITE_P(All, MeasuredOperation, testing::ValuesIn(bench::operations()), [](const auto& row) {
  std::string name{row.param.name};
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return name;
});

}  // namespace
