#include "can/port/wire.hpp"

#include <cerrno>

#include <gtest/gtest.h>
#include <linux/can/error.h>

namespace {

using bus::ErrorState;
using bus::Filter;
using bus::SendStatus;

can_frame error_frame(std::uint32_t classes, std::uint8_t controller = 0, std::uint8_t transmit = 0,
                      std::uint8_t receive = 0) {
  can_frame wire{};
  wire.can_id = CAN_ERR_FLAG | classes;
  wire.len = CAN_ERR_DLC;
  wire.data[1] = controller;
  wire.data[6] = transmit;
  wire.data[7] = receive;
  return wire;
}

ErrorState after(const can_frame& wire, ErrorState before = ErrorState::Active) {
  return bus::decode_error_state(wire, before);
}

// The kernel lets a frame pass if both sides agree in the bits of the mask.
bool passes(const Filter& filter, std::uint32_t received) {
  const can_filter wire = bus::to_wire(filter);
  return (received & wire.can_mask) == (wire.can_id & wire.can_mask);
}

TEST(ErrorFrame, TellsBusOff) {
  EXPECT_EQ(after(error_frame(CAN_ERR_BUSOFF)), ErrorState::BusOff);
}

TEST(ErrorFrame, TellsTheRestartAfterBusOff) {
  EXPECT_EQ(after(error_frame(CAN_ERR_RESTARTED), ErrorState::BusOff), ErrorState::Active);
}

TEST(ErrorFrame, TellsWarningOfEitherSide) {
  EXPECT_EQ(after(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_WARNING)), ErrorState::Warning);
  EXPECT_EQ(after(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING)), ErrorState::Warning);
}

TEST(ErrorFrame, TellsPassiveIfOneSideIsPassiveAndTheOtherOnlyWarns) {
  const auto wire = error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_PASSIVE);

  EXPECT_EQ(after(wire), ErrorState::Passive);
}

TEST(ErrorFrame, TellsTheReturnToActive) {
  EXPECT_EQ(after(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE), ErrorState::Passive), ErrorState::Active);
}

TEST(ErrorFrame, TellsTheStateByTheCountersWhereThereAreSome) {
  EXPECT_EQ(after(error_frame(CAN_ERR_CNT, 0, 95, 95), ErrorState::Passive), ErrorState::Active);
  EXPECT_EQ(after(error_frame(CAN_ERR_CNT, 0, 96, 0)), ErrorState::Warning);
  EXPECT_EQ(after(error_frame(CAN_ERR_CNT, 0, 0, 127)), ErrorState::Warning);
  EXPECT_EQ(after(error_frame(CAN_ERR_CNT, 0, 0, 128)), ErrorState::Passive);
}

TEST(ErrorFrame, BelievesTheControllerBeforeItsCounters) {
  const auto wire = error_frame(CAN_ERR_CRTL | CAN_ERR_CNT, CAN_ERR_CRTL_TX_WARNING, 128, 0);

  EXPECT_EQ(after(wire), ErrorState::Warning);
}

TEST(ErrorFrame, DoesNotLeaveBusOffByCountersAlone) {
  EXPECT_EQ(after(error_frame(CAN_ERR_CNT, 0, 0, 0), ErrorState::BusOff), ErrorState::BusOff);
}

TEST(ErrorFrame, IgnoresCountersThatAreNotMarkedAsSuch) {
  EXPECT_EQ(after(error_frame(CAN_ERR_PROT, 0, 200, 200)), ErrorState::Active);
}

TEST(ErrorFrame, KeepsTheStateOnAnOverrun) {
  const auto wire = error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW);

  EXPECT_EQ(after(wire, ErrorState::Warning), ErrorState::Warning);
}

TEST(FilterEntry, LetsPassItsDataFrameOnly) {
  const Filter filter{.identifier = 0x605};

  EXPECT_TRUE(passes(filter, 0x605));
  EXPECT_FALSE(passes(filter, 0x604));
  EXPECT_FALSE(passes(filter, 0x205));
  EXPECT_FALSE(passes(filter, 0x605 | CAN_RTR_FLAG));
  EXPECT_FALSE(passes(filter, 0x605 | CAN_EFF_FLAG));
}

TEST(FilterEntry, LetsPassItsRemoteFrameOnly) {
  const Filter filter{.identifier = 0x705, .remote = true};

  EXPECT_TRUE(passes(filter, 0x705 | CAN_RTR_FLAG));
  EXPECT_FALSE(passes(filter, 0x705));
  EXPECT_FALSE(passes(filter, 0x705 | CAN_RTR_FLAG | CAN_EFF_FLAG));
}

TEST(FilterEntry, ComparesAll29BitsOfAnExtendedIdentifier) {
  const Filter filter{.identifier = 0x10000181, .extended = true};

  EXPECT_TRUE(passes(filter, 0x10000181 | CAN_EFF_FLAG));
  EXPECT_FALSE(passes(filter, 0x181));
  EXPECT_FALSE(passes(filter, 0x00000181 | CAN_EFF_FLAG));
}

TEST(WireFrame, KeepsEveryMember) {
  const canopen::Frame data{.id = 0x581, .length = 8, .data = {1, 2, 3, 4, 5, 6, 7, 8}};
  const canopen::Frame remote{.id = 0x705, .length = 1, .remote = true};
  const canopen::Frame extended{.id = 0x1FFFFFFF, .length = 2, .extended = true, .data = {1, 2}};

  for (const canopen::Frame& frame : {data, remote, extended})
    EXPECT_EQ(bus::from_wire(bus::to_wire(frame)), frame);
}

TEST(WireFrame, HasZeroesBehindItsLength) {
  can_frame wire{};
  wire.can_id = 0x605;
  wire.len = 2;
  for (auto& byte : wire.data) byte = 0xFF;

  EXPECT_EQ(bus::from_wire(wire), (canopen::Frame{.id = 0x605, .length = 2, .data = {0xFF, 0xFF}}));
}

TEST(SendError, TellsAFullBusFromADeadOneAndFromABadFrame) {
  EXPECT_EQ(bus::to_send_status(ENOBUFS), SendStatus::Full);
  EXPECT_EQ(bus::to_send_status(EAGAIN), SendStatus::Full);
  EXPECT_EQ(bus::to_send_status(ENETDOWN), SendStatus::Down);
  EXPECT_EQ(bus::to_send_status(ENODEV), SendStatus::Down);
  EXPECT_EQ(bus::to_send_status(ENXIO), SendStatus::Down);
  EXPECT_EQ(bus::to_send_status(EINVAL), SendStatus::Failed);
}

}  // namespace
