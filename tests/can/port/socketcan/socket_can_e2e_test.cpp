#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>

#include "can/connection/transmit_queue.hpp"
#include "can/port/socketcan/socket_can.hpp"
#include "tests/support/network.hpp"

namespace {

using namespace std::chrono_literals;
using bus::Filter;
using bus::Received;
using bus::SendStatus;
using bus::SocketCan;
using canopen::Frame;
using network::VirtualCan;

constexpr Frame kRequest{.id = 0x605, .length = 8, .data = {0x40, 0x18, 0x10, 0x01}};

/// The next frame of @p port, nothing if none comes.
std::optional<Frame> next(SocketCan& port) {
  Frame frame;
  while (network::readable(port.descriptor())) {
    const Received received = port.receive(frame);
    if (received.kind == Received::Frame) return frame;
    if (received.kind == Received::Down) return std::nullopt;
  }
  return std::nullopt;
}

/// All frames that wait in @p port now.
std::size_t count_waiting(SocketCan& port) {
  Frame frame;
  std::size_t count = 0;
  while (port.receive(frame).kind == Received::Frame) ++count;
  return count;
}

TEST(SocketCanOnVcan, CarriesDataRemoteAndExtendedFrames) {
  SocketCan master{"vcan0"};
  SocketCan drive{"vcan0"};
  const Frame remote{.id = 0x705, .remote = true};
  const Frame extended{.id = 0x12345678, .length = 2, .extended = true, .data = {1, 2}};

  for (const Frame& frame : {kRequest, remote, extended}) {
    ASSERT_EQ(master.send(frame), SendStatus::Sent);
    EXPECT_EQ(next(drive), frame);
  }
}

TEST(SocketCanOnVcan, DoesNotHearItself) {
  SocketCan port{"vcan0"};
  SocketCan other{"vcan0"};

  ASSERT_EQ(port.send(kRequest), SendStatus::Sent);
  ASSERT_EQ(next(other), kRequest);
  Frame frame;

  EXPECT_EQ(port.receive(frame).kind, Received::Nothing);
}

TEST(SocketCanOnVcan, DoesNotHearTheOtherInterface) {
  SocketCan port{"vcan0"};
  SocketCan other{"vcan1"};
  SocketCan witness{"vcan1"};

  ASSERT_EQ(other.send(kRequest), SendStatus::Sent);
  ASSERT_EQ(next(witness), kRequest);
  Frame frame;

  EXPECT_EQ(port.receive(frame).kind, Received::Nothing);
}

TEST(SocketCanOnVcan, DeliversOnlyWhatItsFiltersName) {
  SocketCan master{"vcan0"};
  SocketCan drive{"vcan0"};
  const std::vector filters{Filter{.identifier = 0x605}, Filter{.identifier = 0x705, .remote = true}};
  const Frame guard{.id = 0x705, .remote = true};
  const Frame end{.id = 0x605, .length = 1};
  drive.accept_only(filters);

  for (const Frame& frame : {kRequest, Frame{.id = 0x604}, Frame{.id = 0x705, .length = 1}, guard,
                             Frame{.id = 0x605, .remote = true}, Frame{.id = 0x605, .extended = true}, end})
    ASSERT_EQ(master.send(frame), SendStatus::Sent);

  EXPECT_EQ(next(drive), kRequest);
  EXPECT_EQ(next(drive), guard);
  EXPECT_EQ(next(drive), end);
}

TEST(SocketCanOnVcan, DeliversNothingWithoutAFilter) {
  SocketCan master{"vcan0"};
  SocketCan drive{"vcan0"};
  SocketCan witness{"vcan0"};
  drive.accept_only({});

  ASSERT_EQ(master.send(kRequest), SendStatus::Sent);
  ASSERT_EQ(next(witness), kRequest);
  Frame frame;

  EXPECT_EQ(drive.receive(frame).kind, Received::Nothing);
}

TEST(SocketCanOnVcan, DeliversEverythingWhenThereAreMoreFiltersThanTheKernelTakes) {
  SocketCan master{"vcan0"};
  SocketCan drive{"vcan0"};
  drive.accept_only(std::vector<Filter>(CAN_RAW_FILTER_MAX + 1, Filter{.identifier = 1}));

  ASSERT_EQ(master.send(kRequest), SendStatus::Sent);

  EXPECT_EQ(next(drive), kRequest);
}

TEST(SocketCanOnVcan, HoldsABurstThatTheDefaultBufferLoses) {
  SocketCan master{"vcan0"};
  SocketCan drive{"vcan0"};
  EXPECT_EQ(drive.receive_buffer(), (bus::ReceiveBuffer{1u << 20, 1u << 20}));

  for (int i = 0; i < 2000; ++i) ASSERT_EQ(master.send(kRequest), SendStatus::Sent);

  std::size_t count = 0;
  while (count < 2000 && next(drive)) ++count;
  EXPECT_EQ(count, 2000u);
  EXPECT_EQ(drive.dropped(), 0u);
}

TEST(SocketCanOnVcan, CountsWhatItsBufferCouldNotHold) {
  SocketCan master{"vcan0"};
  SocketCan drive{"vcan0", 1};
  SocketCan witness{"vcan0"};
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(master.send(kRequest), SendStatus::Sent);
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(next(witness));
  const std::size_t held = count_waiting(drive);
  ASSERT_GT(held, 0u);
  ASSERT_LT(held, 1000u);

  EXPECT_EQ(drive.dropped(), 1000 - held);
}

TEST(SocketCanOnVcan, TellsOnceThatTheInterfaceWentDownAndWorksWhenItIsUpAgain) {
  const VirtualCan can{"vcandown"};
  SocketCan port{can.name()};
  SocketCan other{can.name()};
  Frame frame;

  can.down();
  ASSERT_TRUE(network::readable(port.descriptor()));
  EXPECT_EQ(port.receive(frame).kind, Received::Down);
  EXPECT_EQ(port.receive(frame).kind, Received::Nothing);
  EXPECT_EQ(port.send(kRequest), SendStatus::Down);

  can.up();
  EXPECT_TRUE(port.reopen());
  EXPECT_EQ(other.send(kRequest), SendStatus::Down);  // takes the pending error of the socket
  EXPECT_EQ(other.send(kRequest), SendStatus::Sent);
  EXPECT_EQ(next(port), kRequest);
}

TEST(SocketCanOnVcan, TellsThatTheInterfaceWentDownThoughASendSawItFirst) {
  const VirtualCan can{"vcansend"};
  SocketCan port{can.name()};
  Frame frame;

  can.down();
  ASSERT_EQ(port.send(kRequest), SendStatus::Down);
  ASSERT_EQ(port.send(kRequest), SendStatus::Down);

  EXPECT_EQ(port.receive(frame).kind, Received::Down);
  EXPECT_EQ(port.receive(frame).kind, Received::Nothing);
}

TEST(SocketCanOnVcan, OpensAnInterfaceThatIsDown) {
  const VirtualCan can{"vcanlate"};
  can.down();
  SocketCan port{can.name()};
  Frame frame;

  EXPECT_EQ(port.receive(frame).kind, Received::Down);
  EXPECT_EQ(port.send(kRequest), SendStatus::Down);

  can.up();
  EXPECT_TRUE(port.reopen());
  EXPECT_EQ(port.send(kRequest), SendStatus::Sent);
}

TEST(SocketCanOnVcan, ComesBackWithItsDescriptorAndFiltersWhenTheInterfaceIsMadeAgain) {
  VirtualCan can{"vcanback"};
  SocketCan port{can.name()};
  const int descriptor = port.descriptor();
  port.accept_only(std::vector{Filter{.identifier = 0x605}, Filter{.identifier = 0x705, .remote = true}});
  Frame frame;

  can.remove();
  ASSERT_TRUE(network::readable(port.descriptor()));
  EXPECT_EQ(port.receive(frame).kind, Received::Down);
  EXPECT_EQ(port.send(kRequest), SendStatus::Down);
  EXPECT_FALSE(port.reopen());

  can.create();
  ASSERT_TRUE(port.reopen());
  SocketCan master{can.name()};
  ASSERT_EQ(master.send(Frame{.id = 0x604}), SendStatus::Sent);
  ASSERT_EQ(master.send(kRequest), SendStatus::Sent);
  EXPECT_EQ(next(port), kRequest);
  EXPECT_EQ(port.descriptor(), descriptor);
}

TEST(SocketCanOnVcan, RefusesWhatIsNoCanInterface) {
  EXPECT_THROW(SocketCan{"lo"}, bus::OpenError);
  EXPECT_THROW(SocketCan{"vcan99"}, bus::OpenError);
}

/// Keeps the test on processor @p number, as far as there is one.
void run_on(unsigned number) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(number, &set);
  ::sched_setaffinity(0, sizeof set, &set);
}

/// Two SDO blocks in one turn of the loop: more than a controller with a queue of one frame takes.
void send_blocks(bus::TransmitQueue& queue) {
  for (std::uint8_t i = 0; i < 254; ++i)
    queue.send(Frame{.id = 0x585, .length = 8, .data = {i, 0x55, 0xAA}}, canopen::Delivery::Ordered);
}

/// Serial numbers that @p witness sees on the bus while @p queue gets rid of its frames.
std::vector<int> seen(SocketCan& witness, bus::TransmitQueue& queue, canopen::TimePoint& now) {
  std::vector<int> serials;
  while (serials.size() < 254) {
    queue.retry(now += 250us);
    Frame frame;
    if (witness.receive(frame).kind == Received::Frame)
      serials.push_back(frame.data[0]);
    else if (queue.waiting() == 0 && !network::readable(witness.descriptor()))
      break;
  }
  return serials;
}

TEST(TransmitQueueOnCan, LosesNothingThoughTheControllerCannotTakeTheFramesAtOnce) {
  network::ip("link set can0 down");
  network::ip("link set can0 txqueuelen 1 up type can bitrate 10000");
  SocketCan drive{"can0"};
  SocketCan witness{"can0"};
  bus::TransmitQueue queue{drive};
  canopen::TimePoint now{};
  std::vector<int> all(254);
  std::iota(all.begin(), all.end(), 0);

  // A refusal happens only while another processor than the sender's serves its interrupt.
  constexpr unsigned kRounds = 20;
  for (unsigned round = 0; round < kRounds; ++round) {
    run_on(round % 2);
    send_blocks(queue);
    ASSERT_EQ(seen(witness, queue, now), all);
  }

  EXPECT_GT(queue.counters().refused, 0u);
  EXPECT_GT(queue.counters().queued, 0u);
  EXPECT_EQ(queue.counters().sent, kRounds * 254u);
  EXPECT_EQ(queue.counters().dropped, 0u);
}

}  // namespace
