#include "daemon/bus_loop.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include "tests/fakes/fake_port.hpp"

namespace axisd {
namespace {

using Events = std::vector<std::string>;

/// Notes what it is told, in order.
struct RecordingStation final : Station {
  void on_frame(const canopen::Frame&, canopen::TimePoint) noexcept override { events.emplace_back("frame"); }
  void on_time(canopen::TimePoint) noexcept override {
    events.emplace_back("time");
    deadline = canopen::kNever;
  }
  canopen::TimePoint next_deadline() const noexcept override { return deadline; }
  std::span<const canopen::Subscription> subscriptions() const noexcept override { return {}; }
  void on_burst_end() noexcept override { events.emplace_back("end of a burst"); }

  canopen::TimePoint deadline = canopen::kNever;
  Events events;
};

class BusLoopTest : public testing::Test {
 protected:
  BusLoopTest() {
    port.polled = readable.get();
    EXPECT_TRUE(loop.open());
  }
  void arrive(std::size_t frames) { port.arrived.resize(port.arrived.size() + frames); }

  bus::Descriptor readable{::eventfd(1, EFD_CLOEXEC)};  ///< always
  fakes::FakePort port;
  RecordingStation station;
  BusLoop loop{port, station};
};

TEST_F(BusLoopTest, HandsOverWhatWaitsBeforeItTellsATimeThatIsLate) {
  arrive(5);
  station.deadline = canopen::TimePoint{};  // the start of the machine

  loop.turn();

  EXPECT_EQ(station.events, (Events{"frame", "frame", "frame", "frame", "frame", "time"}));
}

TEST_F(BusLoopTest, TellsTheTimeToAStationOnABusThatNeverStops) {
  arrive(10'000);
  station.deadline = canopen::TimePoint{};

  loop.turn();

  EXPECT_EQ(station.events.back(), "time");
}

TEST_F(BusLoopTest, ReadsOneFrameATurnOtherwise) {
  arrive(2);

  loop.turn();
  EXPECT_EQ(station.events, Events{"frame"});
}

TEST_F(BusLoopTest, TellsThatABurstIsOver) {
  arrive(100);
  station.deadline = canopen::TimePoint{};

  loop.turn();  // late: all of them
  EXPECT_EQ(station.events.size(), 101U);
  arrive(1);
  loop.turn();

  EXPECT_EQ(station.events.back(), "end of a burst");
}

}  // namespace
}  // namespace axisd
