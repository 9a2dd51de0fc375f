// Turns of many buses whose units make the steps of a cycle together.
#include <deque>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include "daemon/loop/event_loop.hpp"
#include "drive/drive_unit.hpp"
#include "os/descriptor.hpp"
#include "tests/fakes/fake_port.hpp"
#include "tests/fakes/standing_time.hpp"

namespace axisd {
namespace {

using Events = std::vector<std::string>;

/// Nothing is rare here.
struct NoService final : Service {
  bool on_rare_event() noexcept override { return false; }
};

/// Has a cycle that is due once, which begins and ends with a frame.
class SharingStation final : public Station {
 public:
  SharingStation(unsigned number, Events& events) : number_{number}, events_{events} {}

  void on_frame(const canopen::Frame&, canopen::TimePoint) noexcept override { note("frame"); }
  void on_time(canopen::TimePoint) noexcept override {
    note("time");
    send(1), send(2);
    deadline_ = canopen::kNever;
  }
  drive::DriveUnit* begin_time(canopen::TimePoint now) noexcept override {
    if (!shares) return on_time(now), nullptr;
    note("begins");
    send(1);
    return &unit_;
  }
  void finish_time(canopen::TimePoint) noexcept override {
    note("finishes");
    send(2);
    deadline_ = canopen::kNever;
  }
  canopen::TimePoint next_deadline() const noexcept override { return deadline_; }
  std::span<const canopen::Subscription> subscriptions() const noexcept override { return {}; }
  void on_turn_over() noexcept override { note("is over"); }
  void on_link_lost() noexcept override { note("link lost"); }

  bool shares = true;
  bus::TransmitQueue* queue = nullptr;

 private:
  void note(const std::string& what) { events_.push_back(std::to_string(number_) + ' ' + what); }
  void send(std::uint8_t which) {
    queue->send({.id = 0x180 + number_, .length = 1, .data = {which}}, canopen::Delivery::Ordered);
  }

  unsigned number_;
  Events& events_;
  drive::DriveUnit unit_{drive::UnitConfiguration{}};
  canopen::TimePoint deadline_{};
};

/// Takes three units at a time.
class ThreeAtATime final : public JointWork {
 public:
  explicit ThreeAtATime(Events& events) : events_{events} {}
  bool add(drive::DriveUnit&) noexcept override {
    if (added_ == 3) return false;
    ++added_;
    return true;
  }
  void make() noexcept override {
    events_.push_back("steps of " + std::to_string(added_));
    added_ = 0;
  }

 private:
  Events& events_;
  int added_ = 0;
};

/// A bus each.
struct Many {
  explicit Many(std::size_t count, bool joint = true) : loop{service, joint ? &work : nullptr} {
    for (unsigned i = 0; i < count; ++i) {
      ports.emplace_back();
      stations.emplace_back(i, events);
      buses.emplace_back(ports.back(), stations.back());
      stations.back().queue = &buses.back().queue();
      EXPECT_TRUE(buses.back().open());
      loop.add(buses.back());
    }
  }
  /// Identifiers and contents of all that was sent.
  std::vector<std::pair<std::uint32_t, int>> sent() const {
    std::vector<std::pair<std::uint32_t, int>> all;
    for (const fakes::FakePort& port : ports)
      for (const canopen::Frame& frame : port.sent) all.emplace_back(frame.id, frame.data[0]);
    return all;
  }

  Events events;
  NoService service;
  ThreeAtATime work{events};
  std::deque<fakes::FakePort> ports;
  std::deque<SharingStation> stations;
  std::deque<BusTurn> buses;
  EventLoop loop;
};

/// All the time that turns take.
class JointTurns : public testing::Test {
  fakes::StandingTime time_;
};

TEST_F(JointTurns, FinishWhenTheStepsAreMadeOfAllThatGoTogether) {
  Many many{6};

  many.loop.turn();

  EXPECT_EQ(many.events,
            (Events{"0 begins",   "1 begins",  "2 begins",   "3 begins",  "steps of 3", "0 finishes", "0 is over",
                    "1 finishes", "1 is over", "2 finishes", "2 is over", "4 begins",   "5 begins",   "steps of 3",
                    "3 finishes", "3 is over", "4 finishes", "4 is over", "5 finishes", "5 is over"}));
}

TEST_F(JointTurns, DoNotWaitWhereNothingIsShared) {
  Many many{5};
  many.stations[1].shares = false;

  many.loop.turn();

  EXPECT_EQ(many.events, (Events{"0 begins", "1 time", "1 is over", "2 begins", "3 begins", "4 begins",
                                 "steps of 3", "0 finishes", "0 is over", "2 finishes", "2 is over", "3 finishes",
                                 "3 is over", "steps of 1", "4 finishes", "4 is over"}));
}

TEST_F(JointTurns, SendTheSameAsByThemselves) {
  Many together{7};
  Many alone{7, false};

  together.loop.turn();
  alone.loop.turn();

  EXPECT_EQ(alone.events[0], "0 time");
  EXPECT_EQ(together.sent().size(), 14U);
  EXPECT_EQ(together.sent(), alone.sent());
}

TEST_F(JointTurns, AreForMoreThanAFewBuses) {
  Many few{PortWatch::kFew};

  few.loop.turn();

  EXPECT_EQ(few.events,
            (Events{"0 time", "0 is over", "1 time", "1 is over", "2 time", "2 is over", "3 time", "3 is over"}));
}

TEST_F(JointTurns, GoOnWithoutALinkThatIsLostInOneOfThem) {
  Many many{5};
  const os::Descriptor readable{::eventfd(1, EFD_CLOEXEC)};
  many.ports[1].polled = readable.get();
  many.ports[1].down = true;
  many.loop.refresh(many.buses[1]);

  many.loop.turn();

  EXPECT_EQ(many.events, (Events{"0 begins", "1 link lost", "1 begins", "2 begins", "3 begins", "steps of 3",
                                 "0 finishes", "0 is over", "1 finishes", "1 is over", "2 finishes", "2 is over",
                                 "4 begins", "steps of 2", "3 finishes", "3 is over", "4 finishes", "4 is over"}));
  EXPECT_FALSE(many.buses[1].is_open());
}

}  // namespace
}  // namespace axisd
