#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

class HeartbeatProducer : public NodeTest {
 protected:
  Lines start_with_period(std::int64_t milliseconds) {
    store_value(0x1017, 0, milliseconds);
    node->start(now);
    return sent();
  }
};

TEST_F(HeartbeatProducer, IsSilentWhileItsTimeIsZero) {
  EXPECT_EQ(start(), (Lines{"705#00"}));

  EXPECT_EQ(passes(1h), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(HeartbeatProducer, BeginsAtOnceWhenItsTimeIsWritten) {
  start();
  passes(17ms);

  EXPECT_EQ(says("605#2B171000640000"), Lines{});  // seven bytes: not a request
  EXPECT_EQ(says("605#2B17100064000000"), (Lines{"585#6017100000000000", "705#7F"}));

  EXPECT_EQ(passes(250ms), (Lines{"117ms 705#7F", "217ms 705#7F"}));
}

TEST_F(HeartbeatProducer, CountsTheBootUpFrameAsItsFirst) {
  EXPECT_EQ(start_with_period(50), (Lines{"705#00"}));

  EXPECT_EQ(passes(120ms), (Lines{"50ms 705#7F", "100ms 705#7F"}));
}

TEST_F(HeartbeatProducer, TellsTheNmtStateInEveryState) {
  start_with_period(100);

  EXPECT_EQ(passes(100ms), (Lines{"100ms 705#7F"}));
  says("000#0105");
  EXPECT_EQ(passes(100ms), (Lines{"200ms 705#05"}));
  says("000#0205");
  EXPECT_EQ(passes(100ms), (Lines{"300ms 705#04"}));
  says("000#8005");
  EXPECT_EQ(passes(100ms), (Lines{"400ms 705#7F"}));
}

TEST_F(HeartbeatProducer, KeepsItsGridWhenItIsCalledLate) {
  start_with_period(100);

  now += 130ms;
  node->on_time(now);
  EXPECT_EQ(sent(), (Lines{"705#7F"}));

  EXPECT_EQ(passes(100ms), (Lines{"200ms 705#7F"}));
}

TEST_F(HeartbeatProducer, DoesNotMakeUpForAPause) {
  start_with_period(100);

  now += 1050ms;
  node->on_time(now);
  EXPECT_EQ(sent(), (Lines{"705#7F"}));

  EXPECT_EQ(passes(150ms), (Lines{"1150ms 705#7F"}));
}

TEST_F(HeartbeatProducer, StopsWhenItsTimeIsSetToZero) {
  start_with_period(100);

  EXPECT_EQ(writes_u16(0x1017, 0, 0), 0U);

  EXPECT_EQ(passes(1s), Lines{});
}

TEST_F(HeartbeatProducer, TakesANewTimeAtOnce) {
  start_with_period(100);
  passes(30ms);

  EXPECT_EQ(writes_u16(0x1017, 0, 20), 0U);

  EXPECT_EQ(passes(50ms), (Lines{"30ms 705#7F", "50ms 705#7F", "70ms 705#7F"}));
}

TEST_F(HeartbeatProducer, ReturnsToItsInitialTimeAfterResetCommunication) {
  start();
  writes_u16(0x1017, 0, 100);
  passes(10ms);

  EXPECT_EQ(says("000#8205"), (Lines{"705#00"}));

  EXPECT_EQ(value_of(0x1017), 0);
  EXPECT_EQ(passes(1s), Lines{});
}

}  // namespace
