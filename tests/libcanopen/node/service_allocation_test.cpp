#include <vector>

#include <gtest/gtest.h>

#include "libcanopen/node/node.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/libcanopen/fixture/service_table.hpp"

namespace {

using namespace std::chrono_literals;

struct CountingBus final : canopen::FrameSink {
  void send(const canopen::Frame&, canopen::Delivery) override { ++sent; }
  std::uint64_t sent = 0;
};

struct CountingApplication final : canopen::Application {
  void on_communication_error(canopen::CommunicationError, std::uint16_t) noexcept override { ++errors; }
  void on_communication_recovery(canopen::CommunicationError, std::uint16_t) noexcept override { ++recoveries; }
  void on_heartbeat(std::uint8_t, canopen::NmtState) noexcept override { ++heartbeats; }
  void on_time_of_day(const canopen::TimeOfDay&) noexcept override { ++times; }
  canopen::Result<void> on_store(std::uint8_t) noexcept override {
    ++stores;
    return {};
  }
  std::uint64_t errors = 0, recoveries = 0, heartbeats = 0, times = 0, stores = 0;
};

/// One round: two nodes that fall silent and come back, guarding likewise, TIME, storage, every object rewritten.
constexpr const char* kRound[] = {
    "605#2316100105000700",
    "605#2316100203000800",
    "605#2B15100014000000",
    "605#2F29100101000000",
    "605#2312100000010080",
    "605#2B0C100002000000",
    "605#2F0D100002000000",
    "707#05",
    "708#7F",
    "705#R",
    "100#000000000000",
    "707#05",
    "000#0105",
    "705#R",
    "605#4003100100000000",
    "605#2F03100000000000",
    "707#00",
    "708#05",
    "605#2310100173617665",
    "605#231110016C6F6164",
    "605#2B17100003000000",
    "705#R",
    "605#2B17100000000000",
    "000#0205",
    "707#04",
    "000#8005",
    "605#2316100200000000",
    "707#7F",
    "605#4001100000000000",
    "605#4003100000000000",
    "605#2312100000010000",
    "000#8205",
};

TEST(Allocation, DoesNotHappenInErrorControlEmcyTimeAndStorage) {
  std::vector<canopen::Frame> frames;
  for (const char* const text : kRound) frames.push_back(fakes::frame_of(text));
  CountingBus bus;
  CountingApplication application;
  canopen::Dictionary dictionary{service_table(), 5};
  canopen::Node node{dictionary, {}, bus, application};
  canopen::TimePoint now{1h};

  const std::uint64_t before = fakes::allocations();
  node.start(now);
  for (unsigned round = 0; round < 500; ++round) {
    for (const canopen::Frame& frame : frames) {
      node.on_frame(frame, now);
      node.raise_error(0xFF00, static_cast<std::uint16_t>(round % 40), 0x80);
      node.clear_error(0xFF00, static_cast<std::uint16_t>((round + 7) % 40));
      now += 1ms;
      node.on_time(now);
    }
  }
  const std::uint64_t during = fakes::allocations() - before;

  EXPECT_EQ(during, 0U);
  EXPECT_GT(before, 0U) << "the counter does not count";
  EXPECT_GE(application.errors, 500U) << "the round does not reach the services";
  EXPECT_EQ(application.recoveries, application.errors);
  EXPECT_GE(application.heartbeats, 500U);
  EXPECT_EQ(application.times, 500U);
  EXPECT_EQ(application.stores, 500U);
}

}  // namespace
