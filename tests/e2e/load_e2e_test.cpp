#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <thread>
#include <vector>

#include <pthread.h>

#include "tests/e2e/daemon_process.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/support/network.hpp"

namespace e2e {
namespace {

using canopen::Frame;

/// @p value in four bytes of @p frame from @p first on.
Frame with_value(Frame frame, std::size_t first, std::uint32_t value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    frame.data[first + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
  return frame;
}
/// RPDO 2: controlword 0 and 60FFh.
Frame target_velocity(std::uint32_t value) {
  return with_value({.id = 0x305, .length = 6}, 2, value);
}
constexpr const char* kAskTargetVelocity = "605#40FF600000000000";
Frame target_velocity_answer(std::uint32_t value) {
  return with_value({.id = 0x585, .length = 8, .data = {0x43, 0xFF, 0x60, 0x00}}, 4, value);
}

struct Flood : RunningDaemon {
  static void SetUpTestSuite() { start(); }

  /// TPDOs are not of interest.
  void SetUp() override {
    can->listen_to({0x485, 0x585, 0x705});
    RunningDaemon::SetUp();
    can->listen_to({0x585});
  }
};

TEST_F(Flood, OfBurstsOfRpdosLosesNothing) {
  constexpr std::uint32_t kBursts = 25;
  constexpr std::uint32_t kBurst = 2000;  // fits into the receive buffer even if the daemon does not run at all
  const std::uint64_t before = daemon->bus_counter("received");

  std::uint32_t value = 0;
  for (std::uint32_t burst = 0; burst < kBursts; ++burst) {
    for (std::uint32_t i = 0; i < kBurst; ++i) can->send(target_velocity(++value));
    ASSERT_TRUE(can->ask(kAskTargetVelocity, fakes::candump(target_velocity_answer(value))));
  }

  EXPECT_EQ(daemon->bus_counter("dropped"), 0u);
  EXPECT_EQ(daemon->bus_counter("received") - before, kBursts * (kBurst + 1));
}

TEST_F(Flood, WithoutAPauseIsReadOrCounted) {
  constexpr std::uint32_t kFrames = 50'000;
  const std::uint64_t before = daemon->bus_counter("received") + daemon->bus_counter("dropped");

  for (std::uint32_t value = 1; value <= kFrames; ++value) can->send(target_velocity(value));

  // A request may find the buffer full, and then has to be repeated.
  std::uint64_t requests = 1;
  constexpr std::uint64_t kMostRequests = 3;
  while (requests < kMostRequests && !can->ask("605#4000100000000000", "585#430010009201FFFF")) ++requests;
  EXPECT_EQ(daemon->bus_counter("received") + daemon->bus_counter("dropped") - before, kFrames + requests);
}

/// Two controllers on one slow bus, of which can0 is the daemon's.
struct FullBus : testing::Test {
  static void SetUpTestSuite() {
    if (!have_controllers()) return;
    for (const char* const name : {"can0", "can1"}) {
      network::ip(std::string{"link set "} + name + " down");
      network::ip(std::string{"link set "} + name + " txqueuelen 2");
      network::ip(std::string{"link set "} + name + " up type can bitrate 10000");
    }
  }
  static void TearDownTestSuite() {
    if (!have_controllers()) return;
    for (const char* const name : {"can0", "can1"}) network::ip(std::string{"link set "} + name + " down");
  }
  static bool have_controllers() { return std::filesystem::exists("/sys/class/net/can0"); }
  void SetUp() override {
    if (have_controllers()) return;
    if (std::getenv("VCAN_VM") != nullptr) GTEST_FAIL() << "the virtual machine has no can0";
    constexpr const char* kReason =
        "no can0: a full transmit queue is shown with the controllers of scripts/vcan-vm";
    std::cout << kReason << '\n';
    GTEST_SKIP() << kReason;
  }
};

/// Other programs on the daemon's interface that keep its transmit queue full, one on each processor: the one that
/// serves the controller's interrupt finds the queue empty whenever it sends.
class Rivals {
 public:
  Rivals() {
    for (unsigned processor = 0; processor < std::thread::hardware_concurrency(); ++processor)
      threads_.emplace_back([processor](const std::stop_token& stop) { run(processor, stop); });
  }

 private:
  static void run(unsigned processor, const std::stop_token& stop) {
    cpu_set_t processors;
    CPU_ZERO(&processors);
    CPU_SET(processor, &processors);
    ::pthread_setaffinity_np(::pthread_self(), sizeof processors, &processors);
    bus::SocketCan port{"can0"};
    port.accept_only({});
    const Frame frame{.id = 0x7FF, .length = 8};
    while (!stop.stop_requested()) {
      if (port.send(frame) != bus::SendStatus::Sent) std::this_thread::yield();
    }
  }
  std::vector<std::jthread> threads_;
};

/// The master on can1, and a witness on can0 who sees what the daemon's controller has really sent.
struct Observers {
  CanClient master{"can1"};
  CanClient witness{"can0"};

  Observers() {
    master.listen_to({});
    witness.listen_to({0x085, 0x185, 0x285, 0x585, 0x705});
  }
  testing::AssertionResult ask(std::string_view request, std::string_view answer) {
    master.send(request);
    return witness.expect(answer);
  }
};

TEST_F(FullBus, CostsNothingButOutdatedTpdos) {
  DaemonProcess daemon{{.interface = "can0", .axis = {{"parameters", {{"p1120", 1.0}}}}}};
  Observers bus;
  ASSERT_TRUE(daemon.is_ready());
  bus.master.send("000#0105");
  ASSERT_TRUE(wait_for_state(bus.witness, kSwitchOnDisabled));
  for (const auto& [word, state] : {std::pair{"205#0600", kReadyToSwitchOn}, std::pair{"205#0700", kSwitchedOn},
                                    std::pair{"305#0F000000800C", kOperationEnabled}}) {
    bus.master.send(word);
    ASSERT_TRUE(wait_for_state(bus.witness, state));
  }
  const Rivals rivals;
  constexpr std::uint64_t kRefusals = 3;
  constexpr int kMostRounds = 100;

  int rounds = 0;
  while (rounds < kMostRounds && daemon.bus_counter("refused") < kRefusals) {
    ++rounds;
    ASSERT_TRUE(bus.ask("605#4000100000000000", "585#430010009201FFFF"));
    ASSERT_TRUE(bus.ask("605#4008100000000000", "585#4108100008000000"));
    ASSERT_TRUE(bus.ask("605#6000000000000000", "585#0053494E414D4943"));
    ASSERT_TRUE(bus.ask("605#7000000000000000", "585#1D53000000000000"));
    ASSERT_EQ(daemon.axisctl({"fault", "inject", "1", "7860"}).status, 0);
    ASSERT_TRUE(bus.witness.expect("085#001081B41E020000"));
    ASSERT_EQ(daemon.axisctl({"fault", "ack", "1"}).status, 0);
    ASSERT_TRUE(bus.witness.expect("085#0000000000000000"));
  }

  EXPECT_GE(daemon.bus_counter("refused"), kRefusals);
  EXPECT_EQ(daemon.bus_counter("send_dropped"), 0u);
  EXPECT_LE(daemon.log_lines("queue"), 1u);
}

}  // namespace
}  // namespace e2e
