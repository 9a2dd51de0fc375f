#include "can/hub/trunk/lease/candidate.hpp"

#include <gtest/gtest.h>

#include "tests/can/hub/told.hpp"

namespace {

using namespace std::chrono_literals;
using canopen::TimePoint;
using hub::trunk::Candidate;
using hub::trunk::Lease;
using told::kStart;

constexpr canopen::Duration kPatience = 500ms;

/// What is kept, and answers that come when a test says so.
struct Bucket {
  Lease::Entry entry;
  bool answers = true;
};

class ToldLease final : public Lease {
 public:
  ToldLease(Bucket& bucket, std::uint32_t hub) : bucket_{bucket}, hub_{hub} {}
  void look() noexcept override { ask(); }
  void take(std::uint64_t revision, std::uint32_t term) noexcept override {
    if (bucket_.entry.revision == revision) bucket_.entry = {.revision = revision + 1, .term = term, .hub = hub_};
    ask();
  }
  [[nodiscard]] std::optional<Entry> take_answer() noexcept override {
    if (!bucket_.answers || !std::exchange(is_asked_, false)) return std::nullopt;
    return bucket_.entry;
  }
  [[nodiscard]] std::string take_problem() override { return {}; }
  unsigned asked = 0;

 private:
  void ask() noexcept {
    is_asked_ = true;
    ++asked;
  }
  Bucket& bucket_;
  std::uint32_t hub_;
  bool is_asked_ = false;
};

struct Hub {
  Hub(Bucket& bucket, std::uint32_t number) : lease{bucket, number}, candidate{lease, number, kPatience} {
    candidate.begin(kStart);
  }
  /// Seeks whenever that is wanted until @p end.
  std::optional<std::uint32_t> seek_until(TimePoint end, std::uint32_t known = 0) {
    while (candidate.next_deadline(known) <= end) {
      now = std::max(now, candidate.next_deadline(known));
      if (const auto gained = candidate.seek(known, now)) return gained;
    }
    now = end;
    return std::nullopt;
  }
  ToldLease lease;
  Candidate candidate;
  TimePoint now = kStart;
};

TEST(Candidate, TakesTheLeaseThatNobodyHasHad) {
  Bucket bucket;
  Hub a{bucket, 1};

  EXPECT_EQ(a.seek_until(kStart + kPatience - 1ns), std::nullopt);
  EXPECT_EQ(bucket.entry.revision, 0U);
  EXPECT_EQ(a.seek_until(kStart + kPatience), 1U);
  EXPECT_EQ(bucket.entry.hub, 1U);
  EXPECT_EQ(bucket.entry.term, 1U);
}

TEST(Candidate, TouchesNothingWhileThereIsAnArbiter) {
  Bucket bucket;
  Hub a{bucket, 1};

  for (TimePoint now = kStart; now < kStart + 5s; now += 90ms) {
    a.candidate.on_arbiter(now);
    EXPECT_EQ(a.seek_until(now + 90ms, 7), std::nullopt);
  }

  EXPECT_EQ(a.lease.asked, 0U);
}

TEST(Candidate, TakesTheLeaseOfOneThatHasGoneForAHigherTerm) {
  Bucket bucket{{.revision = 4, .term = 7, .hub = 2}};
  Hub a{bucket, 1};

  EXPECT_EQ(a.seek_until(kStart + kPatience, 7), 8U);
  EXPECT_EQ(bucket.entry.revision, 5U);
}

TEST(Candidate, TakesItAtOnceWhenATermIsOver) {
  Bucket bucket{{.revision = 4, .term = 7, .hub = 2}};
  Hub a{bucket, 1};
  a.candidate.on_arbiter(kStart);

  a.candidate.on_end(kStart);

  EXPECT_EQ(a.seek_until(kStart, 7), 8U);
}

TEST(Candidate, IsTheOnlyOneThatGainsIt) {
  Bucket bucket{{.revision = 4, .term = 7, .hub = 9}};
  Hub a{bucket, 1};
  Hub b{bucket, 2};
  EXPECT_EQ(a.seek_until(kStart + kPatience - 1ns, 7), std::nullopt);
  EXPECT_EQ(b.seek_until(kStart + kPatience - 1ns, 7), std::nullopt);

  EXPECT_EQ(a.seek_until(kStart + kPatience, 7), 8U);
  EXPECT_EQ(b.seek_until(kStart + kPatience, 7), std::nullopt);

  // a has time to speak, and does not: it has gone.
  EXPECT_EQ(b.seek_until(kStart + 2 * kPatience - 1ns, 7), std::nullopt);
  EXPECT_EQ(b.seek_until(kStart + 2 * kPatience, 7), 9U);
}

TEST(Candidate, GivesWhoeverHasTakenItTimeToSpeak) {
  Bucket bucket{{.revision = 4, .term = 7, .hub = 2}};
  Hub a{bucket, 1};  // has not heard of term 7

  EXPECT_EQ(a.seek_until(kStart + Candidate::kLookAfter + kPatience - 1ns), std::nullopt);
  EXPECT_EQ(a.seek_until(kStart + Candidate::kLookAfter + kPatience), 8U);
}

TEST(Candidate, DoesNotWaitForItself) {
  Bucket bucket{{.revision = 4, .term = 7, .hub = 1}};
  Hub a{bucket, 1};  // has taken it, and did not learn that

  EXPECT_EQ(a.seek_until(kStart + kPatience), 8U);
}

TEST(Candidate, TakesAnAnswerThatComesLater) {
  Bucket bucket;
  bucket.answers = false;
  Hub a{bucket, 1};
  EXPECT_EQ(a.seek_until(kStart + 10s), std::nullopt);
  EXPECT_EQ(a.lease.asked, 1U);

  bucket.answers = true;
  EXPECT_EQ(a.candidate.seek(0, kStart + 10s), 1U);
}

}  // namespace
