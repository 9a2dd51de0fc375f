#include <vector>

#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

constexpr canopen::TimePoint kNow{1h};
constexpr Occurrence kHeartbeat{EventKind::Heartbeat, 0x705};
constexpr Occurrence kSync{EventKind::Sync, 0x080};

/// Which of @p count heartbeats, from 1 on, a fault of them hits.
std::vector<int> hits(std::string_view words, int count) {
  Trigger trigger{fault_of(words), kNow};
  std::vector<int> hit;
  for (int i = 1; i <= count; ++i) {
    trigger.note(kHeartbeat, kNow);
    const bool is_hit = trigger.on_opportunity(kNow);
    if (is_hit)
      hit.push_back(i);
    else
      trigger.note_healthy(kHeartbeat);
  }
  return hit;
}

TEST(Trigger, HitsEveryOpportunityIfNothingIsSaid) {
  EXPECT_EQ(hits("heartbeat.gap", 3), (std::vector{1, 2, 3}));
}

TEST(Trigger, LetsSoManyPassFirst) {
  EXPECT_EQ(hits("heartbeat.gap after=2", 4), (std::vector{3, 4}));
  EXPECT_EQ(hits("heartbeat.gap after=2 times=1", 6), (std::vector{3}));
}

TEST(Trigger, HitsEverySoManyth) {
  EXPECT_EQ(hits("heartbeat.gap every=3", 9), (std::vector{3, 6, 9}));
  EXPECT_EQ(hits("heartbeat.gap every=2 after=1 times=2", 9), (std::vector{3, 5}));
}

TEST(Trigger, EndsWithAMilestoneOfHealthyOnes) {
  EXPECT_EQ(hits("heartbeat.gap every=2 until=3 heartbeat", 9), (std::vector{2, 4}));
}

TEST(Trigger, DrawsTheSameOfTheSameSeed) {
  const auto first = hits("heartbeat.gap probability=0.3 seed=7", 200);
  EXPECT_EQ(first, hits("heartbeat.gap probability=0.3 seed=7", 200));
  EXPECT_NE(first, hits("heartbeat.gap probability=0.3 seed=8", 200));
  EXPECT_GT(first.size(), 30U);
  EXPECT_LT(first.size(), 90U);
  EXPECT_EQ(hits("heartbeat.gap probability=0", 9), std::vector<int>{});
  EXPECT_EQ(hits("heartbeat.gap probability=1", 2), (std::vector{1, 2}));
}

TEST(Trigger, CountsTheEventThatIsNamed) {
  Trigger trigger{fault_of("heartbeat.gap event=sync after=2"), kNow};
  for (const auto phase : {Phase::Waiting, Phase::Active}) {
    EXPECT_FALSE(trigger.on_opportunity(kNow));
    trigger.note(kSync, kNow);
    EXPECT_EQ(trigger.phase(), phase);
  }
  EXPECT_TRUE(trigger.on_opportunity(kNow));
  EXPECT_EQ(trigger.events(), 2U);
}

TEST(Trigger, IsOverWhenItsTimeIs) {
  Trigger trigger{fault_of("heartbeat.gap for_ms=50"), kNow};
  EXPECT_EQ(trigger.deadline(), kNow + 50ms);
  trigger.on_time(kNow + 49ms);
  EXPECT_EQ(trigger.phase(), Phase::Active);
  trigger.on_time(kNow + 50ms);
  EXPECT_EQ(trigger.phase(), Phase::Over);
  EXPECT_FALSE(trigger.on_opportunity(kNow + 50ms));
}

TEST(Trigger, HoldsWhatLastsUntilItsTimeIsOver) {
  Trigger trigger{fault_of("node.gone event=sync times=2 for_ms=10"), kNow};
  EXPECT_TRUE(trigger.on_opportunity(kNow));
  EXPECT_TRUE(trigger.holds());
  EXPECT_FALSE(trigger.on_opportunity(kNow));
  trigger.on_time(kNow + 10ms);
  EXPECT_FALSE(trigger.holds());
  EXPECT_TRUE(trigger.on_opportunity(kNow + 20ms));
  trigger.on_time(kNow + 30ms);
  EXPECT_EQ(trigger.phase(), Phase::Over);
}

TEST(Trigger, KeepsTheNumbersOfTheFirstHits) {
  Trigger trigger{fault_of("heartbeat.gap every=2"), kNow};
  for (int i = 0; i < 100; ++i) static_cast<void>(trigger.on_opportunity(kNow));
  EXPECT_EQ(trigger.hits(), 50U);
  ASSERT_EQ(trigger.hit_at().size(), Trigger::kKept);
  EXPECT_EQ(trigger.hit_at()[1], 4U);
}

TEST(Events, AreSaidByWords) {
  EXPECT_EQ(parse_event("sync"), (Event{EventKind::Sync, {}}));
  EXPECT_EQ(parse_event("frame 185"), (Event{EventKind::Frame, 0x185}));
  EXPECT_EQ(parse_event("frame 0x185"), (Event{EventKind::Frame, 0x185}));
  EXPECT_EQ(parse_milestone("10 heartbeat"), (Milestone{10, {EventKind::Heartbeat, {}}}));
  EXPECT_EQ(text_of(*parse_milestone("3 frame 5")), "3 frame 005");
  for (const char* const wrong :
       {"", "sink", "sync 80", "frame", "frame 20000000", "frame x", "frame 185 ", " sync"})
    EXPECT_EQ(parse_event(wrong).has_value(), std::string_view{wrong} == "frame") << wrong;
  for (const char* const wrong : {"", "10", "0 sync", "x sync", "10  sync", "-1 sync"})
    EXPECT_FALSE(parse_milestone(wrong)) << wrong;
}

TEST(Events, OfAFrameAreThoseOfItsIdentifier) {
  EXPECT_TRUE((Event{EventKind::Frame, 0x705}.matches(kHeartbeat)));
  EXPECT_FALSE((Event{EventKind::Frame, 0x706}.matches(kHeartbeat)));
  EXPECT_TRUE((Event{EventKind::Frame, {}}.matches(kSync)));
  EXPECT_FALSE((Event{EventKind::Frame, {}}.matches({.kind = EventKind::Cycle})));
}

}  // namespace
}  // namespace injection
