#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

class EmcyInhibitTime : public ServiceTest {
 protected:
  /// Boots the node with an inhibit time of @p time, in units of 100 us.
  void start_inhibited(std::uint32_t time) {
    start();
    ASSERT_EQ(writes_u16(0x1015, 0, time), 0U);
  }
  /// The application sends the messages @p first to @p last; what leaves at once.
  Lines raises(std::uint8_t first, std::uint8_t last) {
    node->on_time(now);
    for (unsigned code = first; code <= last; ++code) {
      node->send_emcy(static_cast<std::uint16_t>(0xFF00U | code), 0x81, {});
    }
    return sent();
  }
};

TEST_F(EmcyInhibitTime, OfZeroLetsEveryMessageOutAtOnce) {
  start();

  EXPECT_EQ(raises(1, 3), (Lines{"085#01FF810000000000", "085#02FF810000000000", "085#03FF810000000000"}));
}

TEST_F(EmcyInhibitTime, KeepsMessagesApartInTheirOrder) {
  start_inhibited(100);

  EXPECT_EQ(raises(1, 3), (Lines{"085#01FF810000000000"}));
  EXPECT_EQ(passes(9ms), Lines{});
  EXPECT_EQ(raises(4, 4), Lines{});

  EXPECT_EQ(passes(1s),
            (Lines{"10ms 085#02FF810000000000", "20ms 085#03FF810000000000", "30ms 085#04FF810000000000"}));
}

TEST_F(EmcyInhibitTime, DoesNotDelayAMessageAfterAPause) {
  start_inhibited(100);
  raises(1, 1);
  passes(10ms);

  EXPECT_EQ(raises(2, 2).size(), 1U);
  passes(9ms);
  EXPECT_EQ(raises(3, 3).size(), 0U);
}

TEST_F(EmcyInhibitTime, IsCountedFromTheMessageThatWasLate) {
  start_inhibited(100);
  raises(1, 3);

  now += 17ms;
  node->on_time(now);
  EXPECT_EQ(sent().size(), 1U);

  EXPECT_EQ(passes(1s), (Lines{"27ms 085#03FF810000000000"}));
}

TEST_F(EmcyInhibitTime, LetsSixteenMessagesWaitAndDropsTheOldestOfMore) {
  start_inhibited(10);
  EXPECT_EQ(raises(1, 20), (Lines{"085#01FF810000000000"}));

  const Lines lines = passes(1s);
  ASSERT_EQ(lines.size(), 16U);
  EXPECT_EQ(lines.front(), "1ms 085#05FF810000000000");
  EXPECT_EQ(lines.back(), "16ms 085#14FF810000000000");
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(EmcyInhibitTime, HoldsForWhatWaitsAlready) {
  start_inhibited(10000);
  raises(1, 3);
  passes(5ms);

  EXPECT_EQ(writes_u16(0x1015, 0, 100), 0U);

  EXPECT_EQ(passes(1s), (Lines{"10ms 085#02FF810000000000", "20ms 085#03FF810000000000"}));
}

TEST_F(EmcyInhibitTime, LetsEverythingOutWhenItIsSwitchedOff) {
  start_inhibited(10000);
  raises(1, 3);

  EXPECT_EQ(says("605#2B15100000000000"),
            (Lines{"585#6015100000000000", "085#02FF810000000000", "085#03FF810000000000"}));
}

TEST_F(EmcyInhibitTime, LosesWhatWaitsWhenTheNodeStops) {
  start_inhibited(100);
  raises(1, 3);

  says("000#0205");
  says("000#8005");

  EXPECT_EQ(passes(1s), Lines{});
  EXPECT_EQ(raises(4, 4).size(), 1U);
}

TEST_F(EmcyInhibitTime, LosesWhatWaitsWithAReset) {
  start_inhibited(100);
  raises(1, 3);

  EXPECT_EQ(says("000#8205"), (Lines{"705#00"}));

  EXPECT_EQ(passes(1s), Lines{});
  EXPECT_EQ(value_of(0x1015), 0);
}

TEST_F(EmcyInhibitTime, LosesWhatWaitsWithTheCobId) {
  start_inhibited(100);
  raises(1, 3);

  EXPECT_EQ(writes_u32(0x1014, 0, 0x80000085), 0U);
  EXPECT_EQ(writes_u32(0x1014, 0, 0x85), 0U);

  EXPECT_EQ(passes(1s), Lines{});
}

TEST_F(EmcyInhibitTime, CountsFromStart) {
  store_value(0x1015, 0, 100);
  start();

  EXPECT_EQ(raises(1, 2).size(), 1U);
  EXPECT_EQ(passes(1s), (Lines{"10ms 085#02FF810000000000"}));
}

TEST_F(EmcyInhibitTime, CountsAnewWhenTheNodeIsStartedAgain) {
  start_inhibited(100);
  raises(1, 2);

  start();

  EXPECT_EQ(raises(3, 3), (Lines{"085#03FF810000000000"}));
}

}  // namespace
