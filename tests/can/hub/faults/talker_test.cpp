#include <numeric>

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "can/hub/medium/bit_time.hpp"
#include "tests/can/hub/faults/faulty_bus.hpp"

namespace {

using namespace faulty;

constexpr std::uint32_t kBitRate = 125'000;

/// Share of @p time that the bus was busy with what @p listener has heard, in per cent.
double busy(const told::Listener& listener, canopen::Duration time) {
  unsigned bits = 0;
  for (const hub::Passage& passage : listener.passages) bits += hub::bits_on_wire(passage.frame);
  return 100.0 * bits / kBitRate / std::chrono::duration<double>(time).count();
}

TEST(BusBabble, SendsAFrameEveryPeriod) {
  Bus bus;
  bus.inject("bus.babble id=111 length=2 period_us=1000");
  bus.wait(4500us);
  bus.faults.take_back(std::nullopt);
  bus.wait(10ms);

  EXPECT_EQ(bus.a.seen, Texts(5, "111#0000"));
  EXPECT_FALSE(bus.a.passages[0].local);
}

TEST(BusBabble, IsSilentUntilItsTimeHasCome) {
  Bus bus;
  bus.inject("bus.babble id=111 length=0 period_us=1000 event=frame 080 after=2 times=3");
  bus.wait(10ms);
  bus.send(bus.a, "080#");
  bus.wait(10ms);
  EXPECT_EQ(bus.b.seen, Texts{"080#"});
  bus.send(bus.a, "080#");
  bus.wait(10ms);

  EXPECT_EQ(bus.b.seen, (Texts{"080#", "080#", "111#", "111#", "111#"}));
  EXPECT_EQ(bus.told(), "over 3 of 3");
}

TEST(BusBabble, TakesAllTimeThatLowerIdentifiersLeave) {
  Bus bus{kBitRate};
  bus.inject("bus.babble id=100");
  bus.wait(5ms);
  bus.send(bus.a, "101#");
  bus.send(bus.b, "0FF#");
  bus.wait(95ms);

  EXPECT_GT(busy(bus.c, 100ms), 98.0);
  EXPECT_EQ(std::ranges::count(bus.c.seen, "0FF#"), 1);
  EXPECT_EQ(std::ranges::count(bus.c.seen, "101#"), 0);
  bus.faults.take_back(std::nullopt);
  bus.wait(5ms);
  EXPECT_EQ(bus.c.seen.back(), "101#");  // as soon as the bus is free
}

TEST(BusBabble, LeavesFramesOut) {
  Bus bus{kBitRate};
  bus.inject("bus.babble id=100 every=4 times=10");
  bus.wait(1s);

  EXPECT_EQ(bus.c.seen.size(), 10u);
  EXPECT_EQ(bus.told(), "over 10 of 40");
}

/// A word, and the frame for it.
struct ErrorRow {
  const char* word;
  std::uint32_t error_class;
  std::size_t byte;
  std::uint8_t content;
};

TEST(BusErrorFrames, TellWhatADriverOfTheKernelWould) {
  for (const ErrorRow& row :
       {ErrorRow{"bus-off", CAN_ERR_BUSOFF, 0, 0},
        ErrorRow{"error-passive", CAN_ERR_CRTL, 1, CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE},
        ErrorRow{"error-active", CAN_ERR_CRTL, 1, CAN_ERR_CRTL_ACTIVE}, ErrorRow{"no-ack", CAN_ERR_ACK, 0, 0},
        ErrorRow{"restarted", CAN_ERR_RESTARTED, 0, 0}}) {
    Bus bus;
    bus.inject(std::string{"bus.error-frames times=1 class="} + row.word);
    bus.wait(1ms);

    ASSERT_EQ(bus.a.passages.size(), 1u) << row.word;
    EXPECT_EQ(bus.a.passages[0].frame.can_id, CAN_ERR_FLAG | row.error_class) << row.word;
    EXPECT_EQ(bus.a.passages[0].frame.can_dlc, CAN_ERR_DLC);
    EXPECT_EQ(bus.a.passages[0].frame.data[row.byte], row.content) << row.word;
  }
}

TEST(BusErrorFrames, ComeEveryPeriod) {
  Bus bus;
  bus.inject("bus.error-frames class=bus-error period_ms=10");
  bus.wait(35ms);

  EXPECT_EQ(bus.a.passages.size(), 4u);
}

TEST(BusBitRate, HoldsWhileTheFaultDoes) {
  Bus bus{kBitRate};
  bus.inject("bus.bit-rate bit_rate=10000 for_ms=100");
  bus.wait(1ms);
  bus.send(bus.a, "101#");
  bus.wait(4ms);
  EXPECT_EQ(bus.b.seen, Texts{});  // 47 bits and some
  bus.wait(95ms);
  EXPECT_EQ(bus.b.seen, Texts{"101#"});
  bus.wait(1ms);

  EXPECT_EQ(bus.medium.bit_rate(), kBitRate);
  bus.send(bus.a, "102#");
  bus.wait(1ms);
  EXPECT_EQ(bus.b.seen.back(), "102#");
}

TEST(BusBitRate, GivesABusThatHasNoneOne) {
  Bus bus;
  bus.inject("bus.bit-rate bit_rate=1000");
  bus.wait(0ms);
  bus.send(bus.a, "101#");
  bus.send(bus.a, "102#");
  bus.wait(30ms);
  EXPECT_EQ(bus.b.seen, Texts{});
  bus.faults.take_back(std::nullopt);
  bus.wait(0ms);

  EXPECT_EQ(bus.b.seen, (Texts{"101#", "102#"}));
  EXPECT_EQ(bus.medium.next_deadline(), canopen::kNever);
}

TEST(BusLoad, FillsTheBusUpToAShareOfItsTime) {
  for (const int percent : {20, 50, 90}) {
    Bus bus{kBitRate};
    bus.inject("bus.load percent=" + std::to_string(percent));
    bus.wait(1s);

    EXPECT_NEAR(busy(bus.c, 1s), percent, 2.0);
    EXPECT_EQ(bus.c.seen.front(), "7FF#0000000000000000");
  }
}

TEST(BusLoad, CountsTheFramesOfOthers) {
  Bus bus{kBitRate};
  bus.inject("bus.babble id=100 period_us=4000");  // about a quarter
  bus.inject("bus.load percent=50");
  bus.wait(1s);

  EXPECT_NEAR(busy(bus.c, 1s), 50.0, 2.0);
  EXPECT_EQ(std::ranges::count(bus.c.seen, "100#0000000000000000"), 250);
}

TEST(BusTalkers, AreHitByOtherFaults) {
  Bus bus;
  bus.inject("bus.babble id=111 length=0 period_us=1000 times=4");
  bus.inject("bus.drop id=111 every=2");
  bus.wait(10ms);

  EXPECT_EQ(bus.a.seen, Texts(2, "111#"));
}

}  // namespace
