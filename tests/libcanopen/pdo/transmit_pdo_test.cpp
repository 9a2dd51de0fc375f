#include "tests/libcanopen/fixture/transmit_fixture.hpp"

namespace {

class TransmitPdos : public TransmitTest {
 protected:
  void SetUp() override { start(); }
};

TEST_F(TransmitPdos, OfEventTypeSendTheirFirstFrameOnEnteringOperational) {
  EXPECT_EQ(says("000#0105"), (Lines{"185#4000"}));
  says("000#8005");
  EXPECT_EQ(says("000#0105"), (Lines{"185#4000"}));
  EXPECT_EQ(says("000#0105"), Lines{}) << "already there";
}

TEST_F(TransmitPdos, OfEventTypeSendOnAChangeOnly) {
  operate();

  EXPECT_EQ(sets(0x6041, 0x0040), Lines{});
  EXPECT_EQ(sets(0x6041, 0x1237), (Lines{"185#3712"}));
  EXPECT_EQ(sets(0x6041, 0x1237), Lines{});
  EXPECT_EQ(sets(0x6063, 5), Lines{}) << "not mapped in an event-driven TPDO";
}

TEST_F(TransmitPdos, AreNotSentOutsideOperational) {
  EXPECT_EQ(sets(0x6041, 1), Lines{});
  operate();
  says("000#0205");
  EXPECT_EQ(sets(0x6041, 2), Lines{});
  EXPECT_EQ(says("080#"), Lines{});
}

TEST_F(TransmitPdos, MayBeReplacedOnTheirWayByNewerOnes) {
  node->on_frame(fakes::frame_of("000#0105"), now);

  ASSERT_EQ(bus.deliveries.size(), 1U);
  EXPECT_EQ(bus.deliveries.front(), canopen::Delivery::Replaceable);
}

TEST_F(TransmitPdos, RepeatWithTheirEventTimer) {
  give_times(0, 20);
  operate();

  EXPECT_EQ(passes(50ms), (Lines{"20ms 185#4000", "40ms 185#4000"}));
  EXPECT_EQ(sets(0x6041, 1), (Lines{"185#0100"}));
  EXPECT_EQ(passes(20ms), (Lines{"70ms 185#0100"})) << "the timer starts over with every frame";
}

TEST_F(TransmitPdos, TakeANewEventTimeWhileTheyRun) {
  operate();

  ASSERT_EQ(writes_u16(0x1800, 5, 30), 0U);
  EXPECT_EQ(passes(60ms), (Lines{"30ms 185#4000", "60ms 185#4000"}));
  ASSERT_EQ(writes_u16(0x1800, 5, 0), 0U);
  EXPECT_EQ(passes(1s), Lines{});
}

TEST_F(TransmitPdos, StopTheirEventTimerWithOperational) {
  give_times(0, 20);
  operate();

  says("000#8005");

  EXPECT_EQ(passes(1s), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(TransmitPdos, KeepTheirInhibitTimeAndThenSendTheLatestValues) {
  give_times(100, 0);  // 10 ms
  operate();

  EXPECT_EQ(sets(0x6041, 1), Lines{});
  passes(4ms);
  EXPECT_EQ(sets(0x6041, 2), Lines{});
  EXPECT_EQ(passes(10ms), (Lines{"10ms 185#0200"}));
  EXPECT_EQ(sets(0x6041, 3), Lines{}) << "4 ms after the last";
  EXPECT_EQ(passes(100ms), (Lines{"20ms 185#0300"}));
  EXPECT_EQ(sets(0x6041, 4), (Lines{"185#0400"}));
}

TEST_F(TransmitPdos, KeepTheirInhibitTimeWhenValuesComeBeforeTheTimer) {
  give_times(100, 0);
  operate();
  sets(0x6041, 1);

  now += 10ms;
  EXPECT_EQ(sets(0x6041, 2), (Lines{"185#0200"}));
  EXPECT_EQ(sets(0x6041, 3), Lines{});

  EXPECT_EQ(passes(100ms), (Lines{"20ms 185#0300"}));
}

TEST_F(TransmitPdos, SendNothingAfterTheInhibitTimeIfTheValuesAreAsSent) {
  give_times(100, 0);
  operate();

  sets(0x6041, 1);
  store_value(0x6041, 0, 0x40);

  EXPECT_EQ(passes(100ms), Lines{});
}

TEST_F(TransmitPdos, KeepTheirInhibitTimeAgainstTheirEventTimer) {
  give_times(300, 20);  // 30 ms against 20 ms
  operate();

  EXPECT_EQ(passes(70ms), (Lines{"30ms 185#4000", "60ms 185#4000"}));
}

TEST_F(TransmitPdos, KeepTheirInhibitTimeWhenTheTransmissionTypeIsWritten) {
  give_times(100, 0);
  operate();

  ASSERT_EQ(writes_u8(0x1800, 2, 255), 0U);

  EXPECT_EQ(passes(100ms), (Lines{"10ms 185#4000"}));
}

TEST_F(TransmitPdos, KeepTheirInhibitTimeWhenOperationalIsEnteredAgain) {
  give_times(100, 0);
  operate();
  passes(1ms);
  says("000#8005");

  EXPECT_EQ(says("000#0105"), Lines{});
  EXPECT_EQ(passes(100ms), (Lines{"10ms 185#4000"}));
}

TEST_F(TransmitPdos, SendTheirFirstFrameWhateverTheInhibitTime) {
  ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);
  operate();

  give_times(50000, 0);  // 5 s, set in Operational

  EXPECT_EQ(passes(0ms), (Lines{"0ms 185#4000"}));
}

TEST_F(TransmitPdos, SendAtOnceWhenTheyBecomeValidInOperational) {
  operate();
  ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);
  EXPECT_EQ(sets(0x6041, 7), Lines{});

  ASSERT_EQ(writes_u32(0x1800, 1, 0x40000195), 0U);

  EXPECT_EQ(passes(0ms), (Lines{"0ms 195#0700"}));
}

TEST_F(TransmitPdos, OfType1SendWithEverySync) {
  operate();
  says("080#");
  store_value(0x606C, 0, -2);

  EXPECT_EQ(says("080#"), (Lines{"285#4000FEFFFFFF"}));
  EXPECT_EQ(says("080#"), (Lines{"285#4000FEFFFFFF"}));
}

TEST_F(TransmitPdos, OfTypeNSendWithEveryNthSync) {
  ASSERT_EQ(writes_u32(0x1802, 1, 0xC0000385), 0U);  // TPDO 3 away
  for (const std::uint32_t type : {2U, 3U, 240U}) {
    ASSERT_EQ(writes_u8(0x1801, 2, type), 0U);
    operate();
    for (std::uint32_t sync = 1; sync <= 2 * type + 1; ++sync) {
      const Lines expected = sync % type == 0 ? Lines{"285#400000000000"} : Lines{};
      EXPECT_EQ(says("080#"), expected) << "SYNC " << sync << " of type " << type;
    }
    says("000#8005");
  }
}

TEST_F(TransmitPdos, OfType0SendWithTheSyncAfterAChange) {
  ASSERT_EQ(writes_u32(0x1801, 1, 0xC0000285), 0U);  // TPDO 2 away
  operate();

  EXPECT_EQ(says("080#"), (Lines{"385#00000000"})) << "the first";
  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(sets(0x6063, 0x100), Lines{}) << "waits for SYNC";
  EXPECT_EQ(says("080#"), (Lines{"385#00010000"}));
  EXPECT_EQ(says("080#"), Lines{});
}

TEST_F(TransmitPdos, ShowOneMomentInAllFramesOfASync) {
  // A sink that lets the values run on between two frames, as an owner on another level might.
  class Moving final : public canopen::FrameSink {
   public:
    explicit Moving(canopen::Dictionary& dictionary) : position_{dictionary.cell<std::int32_t>(0x6063, 0)} {}
    void send(const canopen::Frame& frame, canopen::Delivery) override {
      if (frame.id == 0x285) position_.set(999);
      lines.push_back(fakes::candump(frame));
    }
    Lines lines;

   private:
    canopen::Cell<std::int32_t> position_;
  } sink{dictionary};
  canopen::Node moving{dictionary, {}, sink, application};
  moving.start(now);
  moving.on_frame(fakes::frame_of("000#0105"), now);
  sink.lines.clear();

  moving.on_frame(fakes::frame_of("080#"), now);

  EXPECT_EQ(sink.lines, (Lines{"285#400000000000", "385#00000000"}));
}

TEST_F(TransmitPdos, SendWhatWasTrueBeforeTheRpdosOfTheSameSync) {
  ASSERT_EQ(writes_u32(0x1A03, 1, 0x20140010), 0U);  // rw, in TPDO 4 and RPDO 4
  ASSERT_EQ(writes_u8(0x1A03, 0, 1), 0U);
  ASSERT_EQ(writes_u8(0x1803, 2, 1), 0U);
  ASSERT_EQ(writes_u32(0x1803, 1, 0x40000485), 0U);
  ASSERT_EQ(writes_u32(0x1603, 1, 0x20140010), 0U);
  ASSERT_EQ(writes_u8(0x1603, 0, 1), 0U);
  ASSERT_EQ(writes_u8(0x1403, 2, 1), 0U);
  ASSERT_EQ(writes_u32(0x1403, 1, 0x00000505), 0U);
  operate();
  says("505#3412");

  const Lines first = says("080#");
  const Lines second = says("080#");

  EXPECT_EQ(first.back(), "485#0000");
  EXPECT_EQ(second.back(), "485#3412");
}

TEST_F(TransmitPdos, AreNotAnsweredToRemoteFrames) {
  operate();

  EXPECT_EQ(says("185#R2"), Lines{});
}

TEST_F(TransmitPdos, CountTheirSyncsAnewAfterOperationalIsEnteredAgain) {
  ASSERT_EQ(writes_u32(0x1802, 1, 0xC0000385), 0U);
  ASSERT_EQ(writes_u8(0x1801, 2, 3), 0U);
  operate();
  says("080#");
  says("080#");

  says("000#8005");
  operate();

  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(says("080#"), (Lines{"285#400000000000"}));
}

}  // namespace
