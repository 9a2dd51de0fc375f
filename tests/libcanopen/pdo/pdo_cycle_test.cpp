#include "tests/libcanopen/fixture/transmit_fixture.hpp"

namespace {

constexpr canopen::PdoCycle kCycle{4ms, canopen::TimePoint{1h}};

static_assert(kCycle.begin_of(canopen::TimePoint{1h + 7ms}) == canopen::TimePoint{1h + 4ms});
static_assert(kCycle.begin_of(canopen::TimePoint{1h + 8ms}) == canopen::TimePoint{1h + 8ms});
static_assert(kCycle.begin_of(canopen::TimePoint{1h - 1ms}) == canopen::TimePoint{1h - 4ms});
static_assert(kCycle.next_from(canopen::TimePoint{1h + 7ms}) == canopen::TimePoint{1h + 8ms});
static_assert(kCycle.next_from(canopen::TimePoint{1h + 8ms}) == canopen::TimePoint{1h + 8ms});
static_assert(kCycle.whole(0ms) == 0ms && kCycle.whole(1ms) == 4ms && kCycle.whole(4ms) == 4ms);
static_assert(canopen::PdoCycle{}.next_from(canopen::TimePoint{7ms}) == canopen::TimePoint{7ms});
static_assert(canopen::PdoCycle{}.whole(100us) == 100us);

/// A device with a cycle of 4 ms, the first of which began with the time line.
class PdoCycle : public TransmitTest {
 protected:
  void SetUp() override {
    node->set_pdo_cycle({4ms, kStart});
    start();
  }
};

TEST_F(PdoCycle, HoldsTheFirstFrameBackUntilItBegins) {
  passes(1ms);

  EXPECT_EQ(says("000#0105"), Lines{});
  EXPECT_EQ(passes(1s), Lines{"4ms 185#4000"});
}

TEST_F(PdoCycle, SendsTheFirstFrameOnceIfTheValueChangesInIt) {
  passes(1ms);
  operate();
  now = kStart + 4ms;

  EXPECT_EQ(sets(0x6041, 7), Lines{"185#0700"});

  EXPECT_EQ(passes(1s), Lines{});
}

TEST_F(PdoCycle, RoundsTheEventTimerUp) {
  give_times(0, 9);
  passes(1ms);
  operate();

  EXPECT_EQ(passes(31ms), (Lines{"4ms 185#4000", "16ms 185#4000", "28ms 185#4000"}));
}

TEST_F(PdoCycle, RoundsTheInhibitTimeUp) {
  give_times(50, 0);  // 5 ms
  operate();

  now = kStart + 4ms;
  EXPECT_EQ(sets(0x6041, 1), Lines{});
  EXPECT_EQ(passes(8ms), Lines{"8ms 185#0100"});
}

TEST_F(PdoCycle, KeepsItsGridWhenItIsServedLate) {
  give_times(40, 20);  // 4 ms
  operate();

  now = kStart + 5ms;  // for the cycle of 4 ms
  EXPECT_EQ(sets(0x6041, 1), Lines{"185#0100"});
  now = kStart + 8ms;
  EXPECT_EQ(sets(0x6041, 2), Lines{"185#0200"});
  EXPECT_EQ(passes(20ms), Lines{"28ms 185#0200"});
}

TEST_F(PdoCycle, ThatWasMissedSeveralTimesSendsOneFrame) {
  give_times(0, 4);
  operate();

  now += 101ms;
  node->on_time(now);
  EXPECT_EQ(sent(), Lines{"185#4000"});

  EXPECT_EQ(passes(4ms), Lines{"104ms 185#4000"});
}

TEST_F(PdoCycle, LeavesSynchronousTpdosWithTheirSync) {
  operate();
  passes(1ms);

  EXPECT_EQ(says("080#"), (Lines{"285#400000000000", "385#00000000"}));
}

TEST_F(PdoCycle, BindsTimesThatAreWrittenInOperational) {
  operate();
  passes(1ms);

  ASSERT_EQ(writes_u16(0x1800, 5, 10), 0U);
  EXPECT_EQ(passes(23ms), (Lines{"12ms 185#4000", "24ms 185#4000"}));
}

TEST_F(PdoCycle, BindsTpdosThatBecomeValidInOperational) {
  operate();
  ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);
  passes(1ms);

  ASSERT_EQ(writes_u32(0x1800, 1, 0x40000195), 0U);

  EXPECT_EQ(passes(1s), Lines{"4ms 195#4000"});
}

class OffTheBus : public NodeTest {
 protected:
  fakes::VectorBus nowhere;
};

TEST_F(OffTheBus, IsANodeWhoseFramesGoElsewhere) {
  start_operational();
  sent();

  node->send_to(nowhere);
  EXPECT_EQ(says("605#4000100000000000"), Lines{});
  EXPECT_EQ(sets(0x6041, 1), Lines{});
  EXPECT_EQ(nowhere.take().size(), 2U);

  node->send_to(bus);
  EXPECT_EQ(sets(0x6041, 2), Lines{"185#0200"});
}

}  // namespace
