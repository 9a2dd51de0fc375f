#include "os/fresh_pages.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <limits>
#include <system_error>

#include <gtest/gtest.h>

namespace os {
namespace {

constexpr std::size_t kSize = std::size_t{64} << 20U;

/// Memory that this process has of its own (pages).
long own_pages() {
  std::ifstream statm{"/proc/self/statm"};
  long size = 0;
  long resident = 0;
  long of_files = 0;
  statm >> size >> resident >> of_files;
  return resident - of_files;
}

TEST(FreshPages, TakeRoomOnlyWhereTheyAreWrittenTo) {
  const long before = own_pages();
  const FreshPages pages{kSize};
  ASSERT_EQ(pages.bytes().size(), kSize);
  EXPECT_LT(own_pages() - before, 1000);
  std::ranges::fill(pages.bytes(), std::byte{1});
  EXPECT_GT(own_pages() - before, 8000);
}

TEST(FreshPages, AreAsAtFirstWhenGivenBack) {
  FreshPages pages{kSize};
  std::ranges::fill(pages.bytes(), std::byte{1});
  const long full = own_pages();

  pages.give_back();

  EXPECT_GT(full - own_pages(), 8000);
  EXPECT_EQ(pages.bytes()[kSize / 2], std::byte{0});
}

TEST(FreshPages, SayThatThereIsNoRoom) {
  EXPECT_THROW(FreshPages{std::numeric_limits<std::size_t>::max() / 2}, std::system_error);
}

}  // namespace
}  // namespace os
