#include <cerrno>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/bcm.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/hub/broadcast/message.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/can/hub/told.hpp"

namespace hub_test {
namespace {

using hub::broadcast::Head;
using userbus::Kind;
using userbus::Operation;

constexpr std::uint32_t kCycle = SETTIMER | STARTTIMER;

/// What a program gets from the broadcast manager, with one frame.
struct Told {
  Head head;
  can_frame frame;
  userbus::Trailer trailer;
};

class BroadcastMember : public testing::Test {
 protected:
  /// Asks @p client for @p head with the frame @p text; errno.
  static int request(const BusClient& client, const Head& head, std::string_view text, int interface_index = 0) {
    std::vector<std::byte> bytes(sizeof head + sizeof(can_frame));
    const can_frame frame = told::wire(text);
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(&bytes[sizeof head], &frame, sizeof frame);
    return client.ask(Operation::Broadcast, interface_index, bytes).error;
  }

  static Head transmission(std::uint32_t flags) {
    Head head{};
    head.opcode = TX_SETUP;
    head.flags = flags;
    head.ival2 = {.tv_sec = 0, .tv_usec = 1000};
    head.can_id = 0x123;
    head.nframes = 1;
    return head;
  }

  RunningHub hub_;
};

TEST_F(BroadcastMember, SendsInCyclesUntilItLeaves) {
  BusClient receiver{hub_.path()};
  BusClient cyclic{hub_.path(), "can0", Kind::BroadcastManager};

  ASSERT_EQ(request(cyclic, transmission(kCycle), "123#11"), 0);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(receiver.wait_frame(), "123#11");
  cyclic.leave();

  const auto members = [&receiver] {
    userbus::BusStatistics bus{};
    EXPECT_EQ(receiver.ask(Operation::Statistics).error, 0);
    std::memcpy(&bus, receiver.reply().data(), sizeof bus);
    return bus.members;
  };
  while (members() > 1) continue;
  receiver.take();
  receiver.settle();
  EXPECT_TRUE(receiver.take().empty());
}

TEST_F(BroadcastMember, IsToldOfChangesWithTheInterface) {
  BusClient sender{hub_.path(), "vcan0"};
  BusClient watcher{hub_.path(), "can1", Kind::BroadcastManager};
  Head head{};
  head.opcode = RX_SETUP;
  head.can_id = 0x200;
  head.nframes = 1;
  ASSERT_EQ(request(watcher, head, "200#FF"), 0);

  for (const char* const frame : {"200#01", "200#01", "201#02", "200#03"}) sender.send(frame);
  sender.settle();

  std::vector<std::string> changes;
  Told told{};
  while (recv(watcher.descriptor(), &told, sizeof told, MSG_DONTWAIT) == sizeof told) {
    EXPECT_EQ(told.head.opcode, static_cast<std::uint32_t>(RX_CHANGED));
    EXPECT_EQ(told.trailer.interface_index, watcher.index_of("can1"));
    changes.push_back(told::text_of(told.frame));
  }
  EXPECT_EQ(changes, (std::vector<std::string>{"200#01", "200#03"}));
}

TEST_F(BroadcastMember, MustBeBoundFirst) {
  const BusClient unbound{hub_.path(), "", Kind::BroadcastManager};

  EXPECT_EQ(request(unbound, transmission(kCycle), "123#11"), ENOTCONN);
}

TEST_F(BroadcastMember, OnAllInterfacesNamesOneInItsRequests) {
  BusClient receiver{hub_.path(), "any"};
  const BusClient all{hub_.path(), "any", Kind::BroadcastManager};
  const int index = receiver.index_of("can7");

  EXPECT_EQ(request(all, transmission(0), "123#11", index + 1), ENODEV);
  ASSERT_EQ(request(all, transmission(TX_ANNOUNCE), "123#11", index), 0);

  const auto messages = receiver.take();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].trailer.interface_index, index);
}

TEST_F(BroadcastMember, HasNoFramesOfItsOwn) {
  BusClient receiver{hub_.path()};
  const BusClient manager{hub_.path(), "can0", Kind::BroadcastManager};

  manager.send("123#");
  manager.settle();

  EXPECT_TRUE(receiver.take().empty());
}

}  // namespace
}  // namespace hub_test
