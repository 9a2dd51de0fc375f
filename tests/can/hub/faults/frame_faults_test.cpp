#include <gtest/gtest.h>

#include "tests/can/hub/faults/faulty_bus.hpp"

namespace {

using namespace faulty;

TEST(BusDrop, KeepsAFrameFromAllButItsSender) {
  Bus bus;
  bus.inject("bus.drop id=185 times=1");

  bus.send(bus.a, "185#01");
  bus.send(bus.a, "185#02");

  EXPECT_EQ(bus.a.seen, (Texts{"185#01", "185#02"}));
  EXPECT_EQ(bus.a.passages[0].sender, &bus.a);  // its confirmation
  EXPECT_EQ(bus.b.seen, Texts{"185#02"});
  EXPECT_EQ(bus.c.seen, Texts{"185#02"});
  EXPECT_EQ(bus.told(), "over 1 of 1");
  EXPECT_EQ(bus.medium.passed(), 2u);
}

/// Which identifiers a fault is about.
struct Range {
  const char* words;
  Texts heard;  ///< of 180, 1FF, 280 and the extended 00000180
};

void PrintTo(const Range& row, std::ostream* out) {
  *out << row.words;
}

class BusDropOf : public testing::TestWithParam<Range> {};

TEST_P(BusDropOf, HitsIdentifierAndMask) {
  Bus bus;
  bus.inject(GetParam().words);

  for (const char* const frame : {"180#", "1FF#R", "280#", "00000180#", "18FF0180#"}) bus.send(bus.a, frame);

  EXPECT_EQ(bus.b.seen, GetParam().heard);
}

INSTANTIATE_TEST_SUITE_P(Ranges, BusDropOf,
                         testing::Values(Range{"bus.drop", {}},
                                         Range{"bus.drop id=180", {"1FF#R", "280#", "00000180#", "18FF0180#"}},
                                         Range{"bus.drop id=0x180 mask=0x780", {"280#", "00000180#", "18FF0180#"}},
                                         Range{"bus.drop id=18FF0180", {"180#", "1FF#R", "280#", "00000180#"}},
                                         Range{"bus.drop id=180 mask=FFFF", {"180#", "1FF#R", "280#"}}));

TEST(BusDelay, HasOthersHearAFrameLaterAndItsSenderAtOnce) {
  Bus bus;
  bus.inject("bus.delay id=185 delay_ms=20");

  bus.send(bus.a, "185#01");
  bus.send(bus.a, "186#");
  const std::int64_t sent = bus.a.passages[0].time_ns;
  bus.wait(19ms);
  EXPECT_EQ(bus.b.seen, Texts{"186#"});
  bus.wait(1ms);

  EXPECT_EQ(bus.a.seen, (Texts{"185#01", "186#"}));
  EXPECT_EQ(bus.b.seen, (Texts{"186#", "185#01"}));
  EXPECT_GT(bus.b.passages[1].time_ns, sent);
}

TEST(BusDelay, KeepsLateFramesInTheOrderOfTheirTimes) {
  Bus bus;
  bus.inject("bus.delay id=101 delay_ms=30");
  bus.inject("bus.delay id=102 delay_ms=10");

  for (const char* const frame : {"101#01", "102#01", "101#02", "102#02"}) bus.send(bus.a, frame);
  bus.wait(100ms);

  EXPECT_EQ(bus.b.seen, (Texts{"102#01", "102#02", "101#01", "101#02"}));
}

TEST(BusDelay, LosesAndCountsWhatFindsNoRoom) {
  Bus bus;
  bus.inject("bus.delay delay_ms=1000");

  for (std::size_t i = 0; i < hub::faults::LateFrames::kMost + 3; ++i) bus.send(bus.a, "101#");
  bus.wait(1s);

  EXPECT_EQ(bus.b.seen.size(), hub::faults::LateFrames::kMost);
  EXPECT_EQ(bus.faults.lost(), 3u);
}

TEST(BusDelay, NamesNoSenderThatHasLeftMeanwhile) {
  Bus bus;
  bus.inject("bus.delay delay_ms=10");
  bus.send(bus.a, "101#");
  bus.medium.detach(bus.a);
  bus.wait(10ms);

  ASSERT_EQ(bus.b.passages.size(), 1u);
  EXPECT_EQ(bus.b.passages[0].sender, nullptr);
}

TEST(BusDelay, LetsComeWhatIsLateWhenTheFaultHasBeenTakenBack) {
  Bus bus;
  bus.inject("bus.delay delay_ms=10");
  bus.send(bus.a, "101#");
  EXPECT_EQ(bus.faults.take_back(std::nullopt), 1u);
  bus.wait(10ms);

  EXPECT_EQ(bus.b.seen, Texts{"101#"});
  EXPECT_EQ(bus.medium.next_deadline(), canopen::kNever);
}

TEST(BusDuplicate, HasOthersHearAFrameTwiceBeforeAnyOther) {
  Bus bus;
  bus.inject("bus.duplicate id=185 times=1");
  bus.b.at_frame = [&](const hub::Passage& seen) {
    if (bus.b.seen.size() == 1 && seen.frame.can_id == 0x185) bus.send(bus.b, "585#");
  };

  bus.send(bus.a, "185#01");

  EXPECT_EQ(bus.a.seen, (Texts{"185#01", "585#"}));
  EXPECT_EQ(bus.c.seen, (Texts{"185#01", "185#01", "585#"}));
  EXPECT_NE(bus.c.passages[0].mark, bus.c.passages[1].mark);  // a bridge carries both
}

TEST(BusDuplicate, TakesTheTimeOfAnotherFrame) {
  constexpr std::uint32_t kBitRate = 125'000;
  Bus plain{kBitRate};
  plain.send(plain.a, "185#01");
  plain.wait(10ms);
  Bus bus{kBitRate};
  bus.inject("bus.duplicate id=185");
  bus.send(bus.a, "185#01");
  bus.send(bus.b, "080#");
  bus.wait(10ms);

  EXPECT_EQ(bus.c.seen, (Texts{"185#01", "185#01", "080#"}));
  EXPECT_EQ(bus.a.seen, (Texts{"185#01", "080#"}));
  const std::int64_t time = bus.c.passages[1].time_ns - bus.c.passages[0].time_ns;
  EXPECT_GE(time, (47 + 8) * 8'000);  // ns: a frame of one byte at 125 kbit/s, without stuff bits
  EXPECT_LE(time, (47 + 8 + 11) * 8'000);
}

TEST(BusCorrupt, ChangesWhatOthersHear) {
  Bus bus;
  bus.inject("bus.corrupt id=185 byte=1 bits=81");

  bus.send(bus.a, "185#0102");
  bus.send(bus.a, "185#01");
  bus.send(bus.a, "185#R2");

  EXPECT_EQ(bus.a.seen, (Texts{"185#0102", "185#01", "185#R2"}));
  EXPECT_EQ(bus.b.seen, (Texts{"185#0183", "185#01", "185#R2"}));
  EXPECT_EQ(bus.told(), "active 1 of 1");  // the others have no second byte
}

TEST(BusFaults, AddUp) {
  Bus bus;
  bus.inject("bus.corrupt id=185 byte=0 bits=F0");
  bus.inject("bus.delay id=185 delay_ms=5");
  bus.inject("bus.duplicate id=185");

  bus.send(bus.a, "185#01");
  EXPECT_EQ(bus.b.seen, Texts{});
  bus.wait(5ms);

  EXPECT_EQ(bus.b.seen, (Texts{"185#F1", "185#F1"}));
  EXPECT_EQ(bus.a.seen, Texts{"185#01"});
}

TEST(BusFaults, LeaveTheBusAsItWasWhenTakenBack) {
  Bus bus;
  for (const char* const words : {"bus.drop", "bus.cut members=raw", "bus.bit-rate bit_rate=10000"})
    bus.inject(words);
  bus.wait(1ms);
  bus.send(bus.a, "101#");
  EXPECT_EQ(bus.medium.bit_rate(), 10'000u);
  EXPECT_EQ(bus.faults.take_back(2), 1u);
  EXPECT_EQ(bus.faults.take_back(2), 0u);
  EXPECT_EQ(bus.faults.take_back(std::nullopt), 2u);
  bus.wait(1ms);

  bus.send(bus.a, "102#");

  EXPECT_EQ(bus.medium.bit_rate(), 0u);
  EXPECT_EQ(bus.b.seen, (Texts{"101#", "102#"}));
  EXPECT_EQ(bus.medium.next_deadline(), canopen::kNever);
  EXPECT_EQ(bus.faults.list(bus.now), nlohmann::json::array());
}

}  // namespace
