#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include "daemon/loop/event_loop.hpp"
#include "tests/fakes/fake_port.hpp"

namespace axisd {

using Events = std::vector<std::string>;

/// Notes what it is told, in order.
struct RecordingStation : Station, Service {
  void on_frame(const canopen::Frame&, canopen::TimePoint) noexcept override {
    events.emplace_back("frame");
    if (told_frame) told_frame();
    deadline = std::min(deadline, deadline_of_a_frame);
  }
  void on_time(canopen::TimePoint) noexcept override {
    events.emplace_back("time");
    deadline = next;
    if (told_time) told_time();
  }
  bool on_rare_event() noexcept override {
    if (rare_events == 0) return false;
    events.emplace_back("rare");
    return --rare_events != 0;
  }
  canopen::TimePoint next_deadline() const noexcept override { return deadline; }
  std::span<const canopen::Subscription> subscriptions() const noexcept override { return {}; }
  void on_link_lost() noexcept override { events.emplace_back("link lost"); }
  void on_burst_end() noexcept override { events.emplace_back("end of a burst"); }
  void on_flood() noexcept override { events.emplace_back("flood"); }

  canopen::TimePoint deadline = canopen::kNever;
  canopen::TimePoint next = canopen::kNever;  ///< deadline after the one that has come
  canopen::TimePoint deadline_of_a_frame = canopen::kNever;
  int rare_events = 0;  ///< that wait
  std::function<void()> told_frame;
  std::function<void()> told_time;
  Events events;
};

class EventLoopTest : public testing::Test {
 protected:
  EventLoopTest() {
    port.polled = readable.get();
    loop.add(bus);
    EXPECT_TRUE(bus.open());
  }
  void arrive(std::size_t frames) { port.arrived.resize(port.arrived.size() + frames); }

  os::Descriptor readable{::eventfd(1, EFD_CLOEXEC)};  ///< always
  fakes::FakePort port;
  RecordingStation station;
  BusTurn bus{port, station};
  EventLoop loop{station};
};

}  // namespace axisd
