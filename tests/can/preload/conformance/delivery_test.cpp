#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

// That a frame does not come is shown by the next one, which does.

TEST(Delivery, IsToAllOthersInOrder) {
  const CanSocket sender, first, second;

  for (canid_t id = 1; id <= 20; ++id) ASSERT_EQ(sender.send(frame(id)), 0);

  for (canid_t id = 1; id <= 20; ++id) {
    EXPECT_EQ(first.receive_id(), id);
    EXPECT_EQ(second.receive_id(), id);
  }
}

TEST(Delivery, KeepsEveryPartOfAFrame) {
  const CanSocket sender, receiver;
  const can_frame sent = frame(0x1ABCDEF0 | CAN_EFF_FLAG, {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88});
  can_frame remote = frame(0x701 | CAN_RTR_FLAG);
  remote.can_dlc = 4;

  ASSERT_EQ(sender.send(sent), 0);
  ASSERT_EQ(sender.send(remote), 0);

  const auto received = receiver.receive(), request = receiver.receive();
  ASSERT_TRUE(received && request);
  EXPECT_EQ(received->can_id, sent.can_id);
  EXPECT_EQ(received->can_dlc, 8);
  EXPECT_EQ(received->data[7], 0x88);
  EXPECT_EQ(request->can_id, 0x701 | CAN_RTR_FLAG);
  EXPECT_EQ(request->can_dlc, 4);
}

TEST(Delivery, IsNotToTheSender) {
  const CanSocket sender, other;

  ASSERT_EQ(sender.send(frame(0x100)), 0);
  ASSERT_EQ(other.send(frame(0x200)), 0);

  EXPECT_EQ(sender.receive_id(), 0x200u);
}

TEST(Delivery, IsToTheSenderIfItWants) {
  const CanSocket sender;
  ASSERT_EQ(sender.set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, 1), 0);

  ASSERT_EQ(sender.send(frame(0x100)), 0);

  EXPECT_EQ(sender.receive_id(), 0x100u);
}

TEST(Delivery, WithoutLoopbackIsToNobodyHere) {
  const CanSocket sender, other, receiver;
  ASSERT_EQ(sender.set(SOL_CAN_RAW, CAN_RAW_LOOPBACK, 0), 0);

  ASSERT_EQ(sender.send(frame(0x100)), 0);
  ASSERT_EQ(other.send(frame(0x200)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x200u);
}

TEST(Delivery, IsNotToSocketsThatAreNotBound) {
  const CanSocket sender;
  const CanSocket receiver{SOCK_RAW, CAN_RAW};

  ASSERT_EQ(sender.send(frame(0x100)), 0);
  const CanSocket fence;
  ASSERT_EQ(sender.send(frame(0x101)), 0);
  ASSERT_EQ(fence.receive_id(), 0x101u);
  ASSERT_EQ(receiver.bind_to(interface_index()), 0);
  ASSERT_EQ(sender.send(frame(0x200)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x200u);
}

TEST(Delivery, IsToSocketsThatAreBoundToAllInterfaces) {
  const CanSocket sender;
  const CanSocket receiver{SOCK_RAW, CAN_RAW};
  ASSERT_EQ(receiver.bind_to(0), 0);

  ASSERT_EQ(sender.send(frame(0x100)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x100u);
}

constexpr canid_t kBusOff = CAN_ERR_FLAG | CAN_ERR_BUSOFF;

/// Which of the frames 100h, 181h, 182h, 281h and 181h with 29 bits a socket gets that has @p filters. @p end is
/// sent behind them and has to pass.
std::string passed_by(std::initializer_list<can_filter> filters, bool join = false, canid_t end = kBusOff) {
  const CanSocket sender, receiver;
  EXPECT_EQ(receiver.set_filters(filters), 0);
  EXPECT_EQ(receiver.set(SOL_CAN_RAW, CAN_RAW_JOIN_FILTERS, join ? 1 : 0), 0);
  EXPECT_EQ(receiver.set(SOL_CAN_RAW, CAN_RAW_ERR_FILTER, CAN_ERR_BUSOFF), 0);
  for (const canid_t id : {0x100u, 0x181u, 0x182u, 0x281u, 0x181u | CAN_EFF_FLAG})
    EXPECT_EQ(sender.send(frame(id)), 0);
  EXPECT_EQ(sender.send(frame(end)), 0);
  std::string ids;
  for (canid_t id = receiver.receive_id(); id != 0 && id != end; id = receiver.receive_id()) {
    char text[16];
    std::snprintf(text, sizeof text, (id & CAN_EFF_FLAG) != 0 ? "%08x " : "%03x ", id & CAN_EFF_MASK);
    ids += text;
  }
  return ids;
}

TEST(Delivery, IsThroughFilters) {
  constexpr canid_t kExact = CAN_SFF_MASK | CAN_EFF_FLAG;

  EXPECT_EQ(passed_by({}), "");
  EXPECT_EQ(passed_by({{0, 0}}), "100 181 182 281 00000181 ");
  EXPECT_EQ(passed_by({{0x181, CAN_SFF_MASK}}), "181 00000181 ");
  EXPECT_EQ(passed_by({{0x181, kExact}}), "181 ");
  EXPECT_EQ(passed_by({{0x181 | CAN_EFF_FLAG, kExact}}), "00000181 ");
  EXPECT_EQ(passed_by({{0x180, 0x780}}), "181 182 00000181 ");
  EXPECT_EQ(passed_by({{0x181 | CAN_INV_FILTER, kExact}}), "100 182 281 00000181 ");
  EXPECT_EQ(passed_by({{0x100, kExact}, {0x281, kExact}}), "100 281 ");
}

TEST(Delivery, ThroughSeveralFiltersIsOnce) {
  EXPECT_EQ(passed_by({{0x180, 0x780}, {0x181, CAN_SFF_MASK | CAN_EFF_FLAG}}), "181 182 00000181 ");
}

TEST(Delivery, ThroughJoinedFiltersNeedsAll) {
  EXPECT_EQ(passed_by({{0x180, 0x780}, {0x181 | CAN_INV_FILTER, CAN_SFF_MASK | CAN_EFF_FLAG}}, true, 0x183),
            "182 00000181 ");
}

TEST(Delivery, OfErrorFramesIsByTheirOwnFilter) {
  const CanSocket sender, without, with;
  ASSERT_EQ(with.set(SOL_CAN_RAW, CAN_RAW_ERR_FILTER, CAN_ERR_BUSOFF), 0);
  ASSERT_EQ(with.set_filters({}), 0);

  ASSERT_EQ(sender.send(frame(CAN_ERR_FLAG | CAN_ERR_CRTL)), 0);
  ASSERT_EQ(sender.send(frame(CAN_ERR_FLAG | CAN_ERR_BUSOFF)), 0);
  ASSERT_EQ(sender.send(frame(0x123)), 0);

  EXPECT_EQ(without.receive_id(), 0x123u);
  EXPECT_EQ(with.receive_id(), CAN_ERR_FLAG | CAN_ERR_BUSOFF);
}

}  // namespace
}  // namespace conformance
