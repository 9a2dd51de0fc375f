#include <gtest/gtest.h>

#include "tests/can/hub/faults/faulty_bus.hpp"

namespace {

using namespace faulty;

/// Three members: two of process 7, of which a is bound to can0 and b to can1, and c of process 8.
struct Members : Bus {
  explicit Members(std::uint32_t bit_rate = 0) : Bus{bit_rate} {
    a.who = {.name = {"raw"}, .process = 7, .interface_index = interfaces.index_of("can0")};
    b.who = {.name = {"port"}, .process = 7, .interface_index = interfaces.index_of("can1")};
    c.who = {.name = {"unix:/tmp/other"}, .process = 8, .interface_index = 0};
  }
};

/// A cut, and who hears a frame of a.
struct Cut {
  const char* words;
  bool b;
  bool c;
};

void PrintTo(const Cut& row, std::ostream* out) {
  *out << row.words;
}

class BusCut : public testing::TestWithParam<Cut> {};

TEST_P(BusCut, PartsThoseWhomItNamesFromTheOthers) {
  Members bus;
  ASSERT_EQ(bus.inject(GetParam().words), "1");

  bus.send(bus.a, "101#");
  bus.send(bus.c, "102#");

  EXPECT_EQ(bus.a.seen, GetParam().c ? (Texts{"101#", "102#"}) : Texts{"101#"});
  EXPECT_EQ(bus.b.seen.size(), (GetParam().b ? 1u : 0u) + (GetParam().b == GetParam().c ? 1u : 0u));
  EXPECT_EQ(bus.c.seen, GetParam().c ? (Texts{"101#", "102#"}) : Texts{"102#"});
  EXPECT_EQ(bus.told(), "active 1 of 1");
}

INSTANTIATE_TEST_SUITE_P(
    Sides, BusCut,
    testing::Values(Cut{"bus.cut members=7", true, false}, Cut{"bus.cut members=8", true, false},
                    Cut{"bus.cut members=raw", false, false}, Cut{"bus.cut members=can1", false, true},
                    Cut{"bus.cut members=can0,8", false, true},
                    Cut{"bus.cut members=unix:/tmp/other", true, false}, Cut{"bus.cut members=99", true, true},
                    Cut{"bus.cut members=7,8", true, true}));

TEST(BusCutLine, KeepsErrorFramesToo) {
  Members bus;
  bus.inject("bus.cut members=8");
  hub::Passage error = told::passage(bus.a, "101#");
  error.frame.can_id = CAN_ERR_FLAG | CAN_ERR_MASK;
  bus.medium.send(error, bus.now);

  EXPECT_EQ(bus.b.passages.size(), 1u);
  EXPECT_EQ(bus.c.passages.size(), 0u);
}

TEST(BusCutLine, IsOneForTheFramesThatItNames) {
  Members bus;
  bus.inject("bus.cut members=8 id=700 mask=780");

  for (const char* const frame : {"705#05", "185#"}) bus.send(bus.a, frame);

  EXPECT_EQ(bus.c.seen, Texts{"185#"});
}

TEST(BusCutLine, LastsAsLongAsItShall) {
  Members bus;
  bus.inject("bus.cut members=8 for_ms=50");
  bus.send(bus.a, "101#01");
  bus.wait(50ms);
  bus.send(bus.a, "101#02");

  EXPECT_EQ(bus.c.seen, Texts{"101#02"});
  EXPECT_EQ(bus.told(), "over 1 of 1");
}

TEST(BusCutLine, BeginsBehindTheFrameThatIsWaitedFor) {
  Members bus;
  bus.inject("bus.cut members=8 after=2 until=3 frame 080");
  bus.inject("bus.cut members=8 event=frame 080 after=2 for_ms=10");
  EXPECT_EQ(bus.faults.take_back(1), 1u);

  for (const char* const frame : {"080#01", "080#02", "080#03"}) bus.send(bus.a, frame);
  bus.wait(10ms);
  bus.send(bus.a, "080#04");

  EXPECT_EQ(bus.c.seen, (Texts{"080#01", "080#02", "080#04"}));
}

TEST(BusCutLine, ComesAndGoes) {
  Members bus;
  bus.inject("bus.cut members=8 event=frame 080 every=3 times=2 for_ms=1");

  for (int i = 1; i <= 9; ++i) {
    bus.send(bus.a, "080#0" + std::to_string(i));
    bus.send(bus.a, "185#0" + std::to_string(i));
    bus.wait(1ms);
  }

  EXPECT_EQ(bus.told(), "over 2 of 6");
  EXPECT_EQ(bus.c.seen.size(), 16u);
  EXPECT_EQ(std::ranges::count(bus.c.seen, "185#03"), 0);
  EXPECT_EQ(std::ranges::count(bus.c.seen, "185#06"), 0);
}

TEST(BusCutLine, KnowsTheSideOfWhoHasLeft) {
  Members bus{125'000};
  bus.inject("bus.cut members=8");
  {
    told::Listener gone;
    gone.who = {.name = {"raw"}, .process = 8, .interface_index = 0};
    bus.medium.attach(gone);
    bus.send(gone, "101#");
    bus.send(gone, "102#");
    bus.medium.detach(gone);
  }
  bus.wait(10ms);

  EXPECT_EQ(bus.a.seen, Texts{});
  EXPECT_EQ(bus.c.seen, (Texts{"101#", "102#"}));
}

}  // namespace
