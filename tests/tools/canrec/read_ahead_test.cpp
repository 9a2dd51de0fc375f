#include "tools/canrec/play/read_ahead.hpp"

#include <gtest/gtest.h>

#include "tests/tools/canrec/list_source.hpp"

namespace {

using canrec::ReadAhead;
using canrec_test::frame;
using canrec_test::ListSource;

std::vector<canrec::TimedFrame> many(std::uint32_t count) {
  std::vector<canrec::TimedFrame> frames;
  for (std::uint32_t i = 0; i < count; ++i) frames.push_back(frame(std::chrono::milliseconds{i}, i));
  return frames;
}

TEST(ReadAhead, GivesWhatItsSourceHas) {
  constexpr std::uint32_t kCount = 100'000;  // more than may wait
  ListSource source{many(kCount)};
  ReadAhead ahead{source};

  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto next = ahead.next();
    ASSERT_TRUE(next && *next) << i;
    ASSERT_EQ((*next)->frame.can_id, i);
  }
  for (int again = 0; again < 2; ++again) {
    const auto end = ahead.next();
    ASSERT_TRUE(end);
    EXPECT_FALSE(*end);
  }
}

TEST(ReadAhead, FailsBehindTheFramesBeforeTheFailure) {
  ListSource source{many(3), canrec::Failure{canrec::Status::Damaged, "line 4"}};
  ReadAhead ahead{source};

  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ((*ahead.next())->frame.can_id, i);
  const auto end = ahead.next();
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().text, "line 4");
}

TEST(ReadAhead, EndsWhileItsSourceHasMore) {
  ListSource source{many(100'000)};
  ReadAhead ahead{source};
  EXPECT_TRUE(ahead.next());
}

}  // namespace
