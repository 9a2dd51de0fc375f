#include <algorithm>
#include <array>
#include <chrono>

#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include "service/clock.hpp"
#include "tests/daemon/loop/event_loop_fixture.hpp"
#include "tests/fakes/standing_time.hpp"

namespace axisd {
namespace {

/// One whose deadline has come.
struct DueStation : RecordingStation {
  DueStation() { deadline = canopen::TimePoint{}; }
};

TEST_F(EventLoopTest, HandsOverWhatWaitsBeforeItTellsATimeThatIsLate) {
  arrive(5);
  station.deadline = canopen::TimePoint{};  // the start of the machine

  loop.turn();

  EXPECT_EQ(station.events, (Events{"frame", "frame", "frame", "frame", "frame", "time"}));
}

TEST_F(EventLoopTest, TellsTheTimeToAStationOnABusThatNeverStops) {
  arrive(10'000);
  station.deadline = canopen::TimePoint{};

  loop.turn();

  EXPECT_EQ(station.events.back(), "time");
}

TEST_F(EventLoopTest, HandsOverWhatWaitsAlsoWhenAFrameShowsThatTheStationIsLate) {
  arrive(3);
  station.deadline_of_a_frame = canopen::TimePoint{};  // it was at rest before

  loop.turn();

  EXPECT_EQ(station.events, (Events{"frame", "frame", "frame", "time"}));
}

TEST_F(EventLoopTest, HandsOverNothingThatWaitedWhenTheBusWent) {
  port.down = true;
  arrive(3);
  station.deadline = canopen::TimePoint{};  // it is late, too

  loop.turn();

  EXPECT_EQ(station.events, (Events{"link lost", "time"}));
}

TEST_F(EventLoopTest, HandsOverWhatHasComeInOneMessageInOneTurn) {
  port.gathers = true;
  arrive(4);

  loop.turn();

  EXPECT_EQ(station.events, (Events{"frame", "frame", "frame", "frame"}));
}

TEST_F(EventLoopTest, SendsTogetherWhatAFrameOrTheTimeLeadsTo) {
  port.gathers = true;
  const auto send_some = [&] {
    for (int i = 0; i < 4; ++i) bus.queue().send({}, canopen::Delivery::Ordered);
  };
  station.told_frame = send_some;
  station.told_time = send_some;
  arrive(1);
  station.deadline = canopen::TimePoint{};

  loop.turn();

  EXPECT_EQ(port.together, (std::vector<std::size_t>{4, 4}));
  EXPECT_EQ(port.sent.size(), 8u);
}

TEST_F(EventLoopTest, GivesWhatIsRareOneEventATurn) {
  station.rare_events = 4;
  station.next = station.deadline = canopen::TimePoint{};  // a cycle is due in every turn
  arrive(4);

  for (int i = 0; i < 4; ++i) loop.turn();

  EXPECT_EQ(std::ranges::count(station.events, "frame"), 4);
  EXPECT_EQ(std::ranges::count(station.events, "time"), 4);
  const Events last{station.events.end() - 5, station.events.end()};
  EXPECT_EQ(last, (Events{"rare", "time", "rare", "time", "rare"})) << "one after the other";
}

TEST_F(EventLoopTest, DoesNotSleepWhileRareEventsWait) {
  port.polled = -1;
  station.rare_events = 3;

  for (int i = 0; i < 3; ++i) loop.turn();  // nothing else would wake it

  EXPECT_EQ(station.events, (Events{"rare", "rare", "rare"}));
}

TEST_F(EventLoopTest, TellsWhenAFrameHasComeThatWaited) {
  canopen::TimePoint arrival{};
  const canopen::TimePoint before = read_clock();
  loop.turn();
  port.arrival = std::chrono::system_clock::now().time_since_epoch() - std::chrono::hours{1};
  station.told_frame = [&] { arrival = bus.frame_arrival(); };
  while (read_clock() - before < std::chrono::milliseconds{5}) continue;  // it is kept from running
  arrive(1);

  loop.turn();

  EXPECT_GE(arrival, before) << "whatever waits has come since the last turn";
  EXPECT_LE(arrival, read_clock() - std::chrono::milliseconds{1});
}

TEST_F(EventLoopTest, ReadsOneFrameATurnOtherwise) {
  arrive(2);

  loop.turn();
  EXPECT_EQ(station.events, Events{"frame"});
}

TEST_F(EventLoopTest, TellsThatABurstIsOver) {
  arrive(100);
  station.deadline = canopen::TimePoint{};

  loop.turn();  // late: all of them
  EXPECT_EQ(std::ranges::count(station.events, "frame"), 100);
  EXPECT_EQ(std::ranges::count(station.events, "flood"), 1);
  EXPECT_EQ(station.events.size(), 102U);
  arrive(1);
  loop.turn();

  EXPECT_EQ(station.events.back(), "end of a burst");
}

TEST_F(EventLoopTest, TellsThatABurstIsOverWhenNothingMoreComes) {
  arrive(100);
  station.deadline = canopen::TimePoint{};
  loop.turn();
  port.polled = -1;
  station.deadline = canopen::TimePoint{};

  loop.turn();

  EXPECT_EQ(std::ranges::count(station.events, "end of a burst"), 1);
  EXPECT_EQ(station.events.back(), "time");
}

TEST_F(EventLoopTest, TellsThatABurstIsOverWhenTheBusIsClosed) {
  arrive(100);
  station.deadline = canopen::TimePoint{};
  loop.turn();
  bus.close();
  station.deadline = canopen::TimePoint{};

  loop.turn();

  EXPECT_EQ(std::ranges::count(station.events, "end of a burst"), 1);
}

TEST_F(EventLoopTest, GivesEveryBusItsTurnAndWhatIsRareOneEventForAllOfThem) {
  fakes::FakePort other_port;
  other_port.polled = readable.get();
  RecordingStation other;
  BusTurn other_bus{other_port, other};
  loop.add(other_bus);
  ASSERT_TRUE(other_bus.open());
  arrive(2);
  other_port.arrived.resize(1);
  other.deadline = other.next = canopen::TimePoint{};
  station.rare_events = 2;

  loop.turn();

  EXPECT_EQ(station.events, (Events{"frame", "rare"}));
  EXPECT_EQ(other.events, (Events{"frame", "time"}));
}

/// Buses beside that of the fixture, more than are polled; each has a cycle that is due.
struct ManyBuses {
  explicit ManyBuses(EventLoop& loop) {
    for (BusTurn& bus : buses) loop.add(bus);
  }
  /// How many have been told the time, from the first one on; none behind one that has not.
  std::size_t told() const {
    const auto is_told = [](const RecordingStation& station) { return station.events == Events{"time"}; };
    const auto first_without = std::ranges::find_if_not(stations, is_told);
    EXPECT_TRUE(std::none_of(first_without, stations.end(), is_told));
    return static_cast<std::size_t>(first_without - stations.begin());
  }

  fakes::FakePort port;
  std::array<DueStation, PortWatch::kFew> stations;
  std::array<BusTurn, PortWatch::kFew> buses{
      {{port, stations[0]}, {port, stations[1]}, {port, stations[2]}, {port, stations[3]}}};
};

TEST_F(EventLoopTest, LooksAfterWhatIsRareInEveryTurnOfManyBusesWhoseTimerRings) {
  const fakes::StandingTime time;
  port.polled = -1;
  loop.turn();  // nobody has looked after what is rare before
  ManyBuses many{loop};
  const os::Descriptor rare{::eventfd(1, EFD_CLOEXEC)};
  loop.watch(rare.get());
  station.rare_events = 1;

  loop.turn();

  EXPECT_EQ(station.events, Events{"rare"});
  EXPECT_EQ(many.told(), 4U);
}

TEST_F(EventLoopTest, EndsALongTurnOfManyBusesAndGoesOnWithTheNextOne) {
  fakes::StandingTime time;
  port.polled = -1;
  loop.turn();
  ManyBuses many{loop};
  for (RecordingStation& slow : many.stations) slow.told_time = [&time] { time.pass(EventLoop::kLongestTurn); };

  for (std::size_t told = 1; told <= many.stations.size(); ++told) {
    loop.turn();
    EXPECT_EQ(many.told(), told);
  }
}

TEST_F(EventLoopTest, WakesForTheBusWhoseDeadlineIsNext) {
  fakes::FakePort other_port;
  RecordingStation other;
  BusTurn other_bus{other_port, other};
  loop.add(other_bus);
  port.polled = -1;
  loop.turn();  // nobody has looked after what is rare before
  station.deadline = read_clock() + std::chrono::hours{1};
  other.deadline = read_clock() + std::chrono::milliseconds{1};

  while (other.events.empty()) loop.turn();

  EXPECT_EQ(other.events, Events{"time"});
  EXPECT_TRUE(station.events.empty());
}

}  // namespace
}  // namespace axisd
