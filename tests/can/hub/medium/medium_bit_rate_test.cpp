#include <memory>

#include <gtest/gtest.h>

#include "can/hub/medium/bit_time.hpp"
#include "can/hub/medium/medium.hpp"
#include "tests/can/hub/told.hpp"

namespace {

using canopen::kNever;
using canopen::TimePoint;
using hub::Medium;
using hub::Passage;
using told::kStart;
using told::Listener;
using told::passage;
using told::wire;
using Texts = std::vector<std::string>;
using namespace std::chrono_literals;

constexpr std::uint32_t kRate = 500'000;
/// Bit time at kRate.
constexpr canopen::Duration kBit = 2us;

/// Calls on_time() at each deadline until the bus is idle; the time of the last one.
TimePoint run_until_idle(Medium& medium) {
  TimePoint last = medium.now();
  while (medium.next_deadline() != kNever) {
    last = medium.next_deadline();
    medium.on_time(last);
  }
  return last;
}

TEST(MediumWithBitRate, DeliversAFrameWhenItsBitsHavePassed) {
  Medium medium{kRate};
  Listener a;
  medium.attach(a);
  const TimePoint end = kStart + hub::bits_on_wire(wire("123#0102")) * kBit;

  medium.send(passage(a, "123#0102"), kStart);

  EXPECT_EQ(medium.next_deadline(), end);
  medium.on_time(end - 1ns);
  EXPECT_EQ(a.seen, Texts{});
  medium.on_time(end);
  EXPECT_EQ(a.seen, Texts{"123#0102"});
  EXPECT_EQ(medium.next_deadline(), kNever);
}

TEST(MediumWithBitRate, LetsTheLowestIdentifierOfThoseThatWaitWin) {
  Medium medium{kRate};
  Listener first, a, b, c, d;
  for (Listener* each : {&first, &a, &b, &c, &d}) medium.attach(*each);
  medium.send(passage(first, "7FF#"), kStart);  // has the bus to itself
  medium.send(passage(a, "048C0000#"), kStart + 1us);
  medium.send(passage(b, "123#R"), kStart + 2us);
  medium.send(passage(c, "000#R"), kStart + 3us);
  medium.send(passage(d, "123#"), kStart + 4us);

  run_until_idle(medium);

  EXPECT_EQ(first.seen, (Texts{"7FF#", "000#R", "123#", "123#R", "048C0000#"}));
}

TEST(MediumWithBitRate, KeepsTheOrderOfOneParticipant) {
  Medium medium{kRate};
  Listener a, b;
  medium.attach(a);
  medium.attach(b);
  medium.send(passage(a, "7FF#"), kStart);
  medium.send(passage(a, "700#"), kStart);
  medium.send(passage(a, "001#"), kStart);  // lowest, but behind 700h in its controller
  medium.send(passage(b, "300#"), kStart);

  run_until_idle(medium);

  EXPECT_EQ(a.seen, (Texts{"7FF#", "300#", "700#", "001#"}));
}

TEST(MediumWithBitRate, DecidesBetweenEqualFramesByWhoCameFirst) {
  Medium medium{kRate};
  Listener a, b;
  medium.attach(a);
  medium.attach(b);
  medium.send(passage(a, "7FF#"), kStart);
  medium.send(passage(b, "100#0B"), kStart);
  medium.send(passage(a, "100#0A"), kStart);

  run_until_idle(medium);

  EXPECT_EQ(a.seen, (Texts{"7FF#", "100#0B", "100#0A"}));
}

TEST(MediumWithBitRate, GivesNoAdvantageToAFrameThatComesAfterTheBusWasTaken) {
  Medium medium{kRate};
  Listener a, b;
  medium.attach(a);
  medium.attach(b);
  medium.send(passage(a, "200#"), kStart);
  const TimePoint first_end = medium.next_deadline();
  medium.send(passage(a, "300#"), kStart);
  medium.send(passage(b, "001#"), first_end + 1ns);  // 300h has begun by then, though nobody has called on_time()

  run_until_idle(medium);

  EXPECT_EQ(a.seen, (Texts{"200#", "300#", "001#"}));
}

TEST(MediumWithBitRate, CatchesUpExactlyWhenItIsCalledLate) {
  Medium medium{kRate};
  Listener a;
  medium.attach(a);
  const Texts frames{"100#", "200#0102030405060708", "00000300#R", "400#FFFFFFFF"};
  for (const std::string& frame : frames) medium.send(passage(a, frame), kStart);

  medium.on_time(kStart + 1s);

  ASSERT_EQ(a.seen, frames);
  for (std::size_t i = 1; i < frames.size(); ++i)
    EXPECT_EQ(a.passages[i].time_ns - a.passages[i - 1].time_ns,
              (hub::bits_on_wire(wire(frames[i])) * kBit).count());
}

TEST(MediumWithBitRate, BeginsAFrameOfAnIdleBusWhenItIsHandedOver) {
  Medium medium{kRate};
  Listener a;
  medium.attach(a);
  medium.send(passage(a, "100#"), kStart);
  medium.on_time(kStart + 1s);

  medium.send(passage(a, "100#"), kStart + 2s);

  EXPECT_EQ(medium.next_deadline(), kStart + 2s + hub::bits_on_wire(wire("100#")) * kBit);
}

TEST(MediumWithBitRate, RefusesWhenTheQueueIsFullAndTellsWhenThereIsRoom) {
  Medium medium{kRate};
  Listener a;
  medium.attach(a);
  unsigned accepted = 0;
  while (medium.send(passage(a, "100#"), kStart)) ++accepted;
  ASSERT_EQ(accepted, Medium::kQueue + 1);  // one is on the wire
  ASSERT_EQ(a.rooms, 0u);

  medium.on_time(medium.next_deadline());

  EXPECT_EQ(a.rooms, 1u);
  EXPECT_TRUE(medium.send(passage(a, "100#"), medium.now()));
  EXPECT_FALSE(medium.send(passage(a, "100#"), medium.now()));
}

TEST(MediumWithBitRate, TakesAFrameFromWithinOnRoom) {
  Medium medium{kRate};
  Listener a;
  medium.attach(a);
  a.at_room = [&] { EXPECT_TRUE(medium.send(passage(a, "7FF#"), medium.now())); };
  while (medium.send(passage(a, "100#"), kStart)) continue;

  run_until_idle(medium);

  EXPECT_EQ(a.seen.size(), Medium::kQueue + 2);
  EXPECT_EQ(a.seen.back(), "7FF#");
}

TEST(MediumWithBitRate, SendsWhatAParticipantThatLeftHadWaiting) {
  Medium medium{kRate};
  Listener receiver;
  medium.attach(receiver);
  {
    Listener gone;
    medium.attach(gone);
    medium.send(passage(gone, "100#"), kStart);
    medium.send(passage(gone, "200#"), kStart);
    medium.detach(gone);
  }

  run_until_idle(medium);

  EXPECT_EQ(receiver.seen, (Texts{"100#", "200#"}));
  EXPECT_EQ(receiver.passages[0].sender, nullptr);
  EXPECT_EQ(receiver.passages[1].sender, nullptr);
}

TEST(MediumWithBitRate, DoesNotLetTimeRunBackwards) {
  Medium medium{kRate};
  Listener a;
  medium.attach(a);
  medium.on_time(kStart + 1s);

  medium.send(passage(a, "100#"), kStart);

  EXPECT_EQ(medium.now(), kStart + 1s);
  EXPECT_EQ(medium.next_deadline(), kStart + 1s + hub::bits_on_wire(wire("100#")) * kBit);
}

/// A frame of random identifier, format and data.
can_frame random_frame(std::mt19937& random) {
  can_frame frame{};
  frame.can_id = random() % 2 == 0 ? random() % 0x800 : CAN_EFF_FLAG | random() % 0x20000000;
  if (random() % 8 == 0) frame.can_id |= CAN_RTR_FLAG;
  frame.can_dlc = static_cast<std::uint8_t>(random() % 9);
  for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random());
  return frame;
}

TEST(MediumWithBitRate, IsBusyForTheSumOfAllBitsWhateverTheOrderAndTheRate) {
  const unsigned seed = told::seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random{seed};
  for (const std::uint32_t rate : {10'000U, 83'333U, 125'000U, 500'000U, 1'000'000U}) {
    Medium medium{rate};
    std::vector<std::unique_ptr<Listener>> all;
    for (int i = 0; i < 5; ++i) medium.attach(*all.emplace_back(std::make_unique<Listener>()));
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < 5 * Medium::kQueue; ++i) {
      Passage next;
      next.frame = random_frame(random);
      next.sender = all[i % all.size()].get();
      bits += hub::bits_on_wire(next.frame);
      ASSERT_TRUE(medium.send(next, kStart));
    }

    const TimePoint end = run_until_idle(medium);

    EXPECT_EQ((end - kStart).count(), static_cast<std::int64_t>(bits * 1'000'000'000 / rate)) << rate << " bit/s";
    EXPECT_EQ(all[0]->seen.size(), 5 * Medium::kQueue);
    EXPECT_EQ(all[0]->seen, all[4]->seen);
  }
}

TEST(MediumWithBitRate, DoesNotDriftOnABusThatIsBusyForHours) {
  Medium medium{10'000};
  Listener a;
  medium.attach(a);
  a.at_frame = [&](const Passage&) { medium.send(passage(a, "100#"), medium.now()); };
  medium.send(passage(a, "100#"), kStart);
  const std::uint64_t bits = hub::bits_on_wire(wire("100#"));
  medium.send(passage(a, "100#"), kStart);  // so that the bus is never idle

  std::uint64_t frames = 1;
  for (; frames < 1'000'000; ++frames) medium.on_time(medium.next_deadline());

  EXPECT_EQ((medium.next_deadline() - kStart).count(), static_cast<std::int64_t>(frames * bits * 100'000));
}

}  // namespace
