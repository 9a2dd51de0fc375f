#include "can/hub/trunk/arbiter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "can/hub/medium/bit_time.hpp"
#include "can/hub/trunk/lateness.hpp"
#include "tests/can/hub/told.hpp"

namespace {

using namespace std::chrono_literals;
using canopen::kNever;
using canopen::TimePoint;
using hub::trunk::Arbiter;
using hub::trunk::Header;
using hub::trunk::Kind;
using hub::trunk::Reader;
using hub::trunk::Writer;
using told::kStart;
using told::wire;
using Texts = std::vector<std::string>;

constexpr std::uint32_t kRate = 125'000;
constexpr canopen::Duration kBit = 8us;
constexpr std::uint32_t kTerm = 3;

/// A hub that asks an arbiter.
struct Hub {
  Hub(Arbiter& its_arbiter, std::uint32_t its_number) : arbiter{its_arbiter} {
    header = {.hub = its_number, .epoch = 1, .counter = 1, .term = kTerm};
  }

  void ask(const Texts& frames, TimePoint now, std::uint32_t station = 1) {
    header.kind = Kind::Frames;
    header.origin = header.hub;
    header.detail = station;
    Writer writer;
    writer.begin(header);
    for (const std::string& frame : frames) writer.add({wire(frame), number++});
    header.counter += frames.size();
    give(writer, now);
  }
  void beat(TimePoint now) {
    header.kind = Kind::Beat;
    header.detail = kRate;
    Writer writer;
    writer.begin(header);
    give(writer, now);
  }
  void give(Writer& writer, TimePoint now) const {
    std::string_view problem;
    const auto request = Reader::read(writer.finish(), problem);
    ASSERT_TRUE(request) << problem;
    arbiter.take(*request, seen, now);
  }

  Arbiter& arbiter;
  Header header;
  std::int64_t seen = 0;  ///< by the arbiter's hub
  std::uint32_t number = 1;
};

class ArbiterTest : public testing::Test {
 protected:
  ArbiterTest() { arbiter.begin(kTerm); }

  /// What passes until nothing waits.
  std::vector<Arbiter::Granted> run() {
    std::vector<Arbiter::Granted> passed;
    now = std::max(now, kStart);
    for (;;) {
      while (const auto granted = arbiter.pass(now)) passed.push_back(*granted);
      if (arbiter.next_deadline() == kNever) return passed;
      now = arbiter.next_deadline();
    }
  }
  static Texts texts_of(const std::vector<Arbiter::Granted>& passed) {
    Texts texts;
    for (const Arbiter::Granted& granted : passed) texts.push_back(told::text_of(granted.frame.frame));
    return texts;
  }

  Arbiter arbiter{kRate};
  Hub a{arbiter, 0xA}, b{arbiter, 0xB}, c{arbiter, 0xC};
  TimePoint now = kStart;
};

TEST_F(ArbiterTest, LetsTheLowestIdentifierOfAllHubsPass) {
  a.ask({"7FF#"}, kStart);
  arbiter.pass(kStart);  // has the bus to itself
  a.ask({"300#"}, kStart);
  b.ask({"200#"}, kStart);
  b.ask({"048C0000#"}, kStart, 2);
  c.ask({"123#R"}, kStart);
  c.ask({"123#"}, kStart, 2);

  EXPECT_EQ(texts_of(run()), (Texts{"7FF#", "123#", "123#R", "048C0000#", "200#", "300#"}));
}

TEST_F(ArbiterTest, KeepsTheOrderOfAStation) {
  a.ask({"7FF#", "700#", "001#"}, kStart);
  a.ask({"300#"}, kStart, 2);

  EXPECT_EQ(texts_of(run()), (Texts{"300#", "7FF#", "700#", "001#"}));
}

TEST_F(ArbiterTest, GivesEveryFrameTheTimeOfItsBitsHoweverLateItLooks) {
  const Texts frames{"100#", "200#0102030405060708", "00000300#R", "400#FFFFFFFF"};
  a.ask(frames, kStart);
  EXPECT_EQ(arbiter.pass(kStart), std::nullopt);
  EXPECT_EQ(arbiter.next_deadline(), kStart + hub::bits_on_wire(wire(frames[0])) * kBit);

  now = kStart + 1s;
  const auto passed = run();

  ASSERT_EQ(texts_of(passed), frames);
  for (std::size_t i = 1; i < passed.size(); ++i)
    EXPECT_EQ(passed[i].end - passed[i - 1].end,
              std::chrono::nanoseconds{hub::bits_on_wire(wire(frames[i])) * kBit}.count());
}

TEST_F(ArbiterTest, GivesNoAdvantageToAFrameThatComesAfterTheBusWasTaken) {
  a.ask({"200#", "300#"}, kStart);
  arbiter.pass(kStart);
  b.ask({"001#"}, arbiter.next_deadline() + 1ns);  // 300h has begun by then, though nobody has looked

  EXPECT_EQ(texts_of(run()), (Texts{"200#", "300#", "001#"}));
}

TEST_F(ArbiterTest, LetsAFrameThatHasLostForLongPassAtLast) {
  a.ask({"7FF#"}, kStart + 1us);
  b.ask({"001#"}, kStart);
  Texts seen;
  for (now = kStart; now < kStart + 20s;) {
    while (const auto granted = arbiter.pass(now)) {
      seen.push_back(told::text_of(granted->frame.frame));
      b.ask({"001#"}, now - 1ns);  // there is always another one
    }
    now = arbiter.next_deadline();
  }
  EXPECT_GT(seen.size(), 20'000U);
  EXPECT_THAT(seen, testing::Each("001#"));

  for (const auto& granted : run()) seen.push_back(told::text_of(granted.frame.frame));

  EXPECT_EQ(seen.back(), "7FF#");
}

TEST_F(ArbiterTest, NumbersTheFramesOfAHubAsTheyPass) {
  a.header.counter = 41;
  a.ask({"300#"}, kStart, 7);
  a.ask({"200#"}, kStart, 8);

  const auto passed = run();

  ASSERT_EQ(texts_of(passed), (Texts{"200#", "300#"}));
  EXPECT_EQ(passed[0].header.counter, 41U);
  EXPECT_EQ(passed[0].header.station(), 8U);
  EXPECT_EQ(passed[0].header.hub, 0xAU);
  EXPECT_EQ(passed[0].header.origin, 0xAU);
  EXPECT_EQ(passed[1].header.counter, 42U);
  EXPECT_EQ(passed[1].frame.number, 1U);
}

TEST_F(ArbiterTest, LosesAllOfAHubOfWhichARequestIsMissing) {
  a.ask({"300#"}, kStart);
  b.ask({"400#"}, kStart);
  ++a.header.counter;
  a.beat(kStart);

  EXPECT_EQ(texts_of(run()), (Texts{"400#"}));
  const auto lost = arbiter.take_lost();
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->hub, 0xAU);
  EXPECT_EQ(lost->epoch, 1U);
  EXPECT_FALSE(arbiter.take_lost());
  a.ask({"301#"}, kStart);
  EXPECT_EQ(run().size(), 0U);
}

TEST_F(ArbiterTest, LosesAllOfAHubThatAsksForMoreThanItMay) {
  a.ask(Texts(hub::kMostWaiting, "300#"), kStart);
  a.ask({"300#"}, kStart);

  EXPECT_EQ(run().size(), 0U);
  EXPECT_TRUE(arbiter.take_lost());
}

TEST_F(ArbiterTest, LosesTheFrameOnTheBusWithItsHub) {
  a.ask({"300#"}, kStart);
  arbiter.pass(kStart);
  ++a.header.counter;
  a.beat(kStart);
  b.ask({"400#"}, kStart);

  const auto passed = run();

  EXPECT_EQ(texts_of(passed), (Texts{"400#"}));
  const unsigned bits = hub::bits_on_wire(wire("300#")) + hub::bits_on_wire(wire("400#"));
  EXPECT_EQ(now, kStart + bits * kBit);  // its time was taken
}

TEST_F(ArbiterTest, LosesAllOfAHubWithoutContact) {
  const std::int64_t seen = std::chrono::nanoseconds{10s}.count();
  const std::int64_t patience = hub::trunk::kMostLateness.count();
  a.header.seen = seen;
  b.header.seen = seen + 1;
  a.ask({"300#"}, kStart);
  b.ask({"400#"}, kStart);

  arbiter.look(seen + patience);
  EXPECT_FALSE(arbiter.take_lost());
  arbiter.look(seen + patience + 1);

  ASSERT_EQ(arbiter.take_lost().value_or(Header{}).hub, 0xAU);
  EXPECT_EQ(texts_of(run()), (Texts{"400#"}));
}

TEST_F(ArbiterTest, LosesAllOfAHubWhoseRequestIsLate) {
  a.header.seen = 1;
  a.seen = 1 + hub::trunk::kMostLateness.count() + 1;
  a.ask({"300#"}, kStart);

  EXPECT_EQ(run().size(), 0U);
  EXPECT_TRUE(arbiter.take_lost());
}

TEST_F(ArbiterTest, ForgetsWhatAHubHasAskedForBeforeItHasJoinedAnew) {
  a.ask({"300#"}, kStart);
  arbiter.on_epoch(0xA, 2);
  a.ask({"301#"}, kStart);  // was on its way
  a.header.epoch = 2;
  a.header.counter = 20;
  a.ask({"302#"}, kStart);

  const auto passed = run();

  ASSERT_EQ(texts_of(passed), (Texts{"302#"}));
  EXPECT_EQ(passed[0].header.counter, 20U);
  EXPECT_FALSE(arbiter.take_lost());
}

TEST_F(ArbiterTest, TakesNothingThatWasAskedOfAnother) {
  a.header.term = kTerm - 1;
  a.ask({"300#"}, kStart);
  EXPECT_EQ(run().size(), 0U);
  EXPECT_FALSE(arbiter.take_lost());

  a.header.term = kTerm;
  a.ask({"301#"}, kStart);
  arbiter.begin(kTerm + 1);
  EXPECT_EQ(arbiter.waiting(), 0U);
  EXPECT_EQ(run().size(), 0U);
}

TEST_F(ArbiterTest, MakesRoomForAHubInThePlaceOfOneThatHasGone) {
  const std::int64_t patience = hub::trunk::kMostLateness.count();
  std::vector<Hub> many;
  for (std::uint32_t i = 0; i < Arbiter::kMostHubs; ++i) many.emplace_back(arbiter, 100 + i).header.seen = 1 + i;
  for (Hub& each : many) each.beat(kStart);
  a.ask({"300#"}, kStart);
  EXPECT_EQ(arbiter.take_lost().value_or(Header{}).hub, 0xAU);

  arbiter.look(1 + patience + 1);
  EXPECT_EQ(arbiter.take_lost().value_or(Header{}).hub, 100U);
  a.header.epoch = 2;
  a.ask({"301#"}, kStart);

  EXPECT_EQ(texts_of(run()), (Texts{"301#"}));
}

}  // namespace
