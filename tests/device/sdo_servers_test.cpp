#include <algorithm>
#include <array>
#include <bit>

#include "libcanopen/base/little_endian.hpp"
#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint32_t kNoObject = 0x06020000, kNoSubIndex = 0x06090011, kInvalidValue = 0x06090030;
constexpr std::uint32_t kCollision = 0x06040043, kDeviceState = 0x08000022;
constexpr std::uint32_t kOff = 0x80000000;

constexpr std::uint16_t object_of(std::uint16_t number) {
  return static_cast<std::uint16_t>(0x2000 + number);
}

/// The identifiers of an SDO server, of the default one unless said otherwise.
struct SdoServerIds {
  std::uint32_t request = 0x605;
  std::uint32_t response = 0x585;
};

/// A client of the server with the identifiers @p ids.
class ServerClient final : public sdo_test::SdoClient {
 public:
  ServerClient(TestUnit& unit, const SdoServerIds& ids) : SdoClient{ids.request}, unit_{unit}, ids_{ids} {}

 private:
  std::optional<canopen::Frame> ask(const canopen::Frame& request) override {
    unit_.device.on_frame(request, unit_.now);
    const std::vector<canopen::Frame> answers = unit_.bus.take();
    const auto answer = std::ranges::find(answers, ids_.response, &canopen::Frame::id);
    return answer != answers.end() ? std::optional{*answer} : std::nullopt;
  }

  TestUnit& unit_;
  SdoServerIds ids_;
};

/// The identifiers that the manual suggests for the server of drive object @p object of node 5, moved up where
/// they would collide with nothing.
constexpr SdoServerIds server_of(unsigned object) {
  return {0x610 + object, 0x590 + object};
}

constexpr std::uint16_t record_of(unsigned object) {
  return static_cast<std::uint16_t>(0x1200 + object);
}

/// A unit of eight axes; a test switches on what it needs of its servers.
struct EightAxes : TestUnit {
  EightAxes() : TestUnit{{.node_id = 5, .axes = std::vector<AxisSetup>(8)}} { start(); }

  using TestUnit::download;
  using TestUnit::upload;
  Upload upload(std::uint16_t index, std::uint8_t sub_index, const SdoServerIds& server) {
    return ServerClient{*this, server}.upload(index, sub_index);
  }
  void switch_on(unsigned object) {
    ASSERT_EQ(download(record_of(object), 1, server_of(object).request, 4), 0U) << object;
    ASSERT_EQ(download(record_of(object), 2, server_of(object).response, 4), 0U) << object;
  }
  void switch_all_on() {
    for (unsigned object = 1; object <= 9; ++object) switch_on(object);
  }
};

canopen::Frame frame_to(const SdoServerIds& server, std::uint8_t command, std::uint16_t index,
                        std::uint32_t value = 0) {
  canopen::Frame frame{.id = server.request, .length = 8};
  frame.data[0] = command;
  canopen::store(&frame.data[1], index);
  canopen::store(&frame.data[4], value);
  return frame;
}

TEST(SdoServers, OfTheDriveObjectsAreOffFromTheFactory) {
  EightAxes unit;

  for (unsigned object = 1; object <= 9; ++object) {
    EXPECT_EQ(unit.upload(record_of(object), 1).number(), kOff);
    EXPECT_EQ(unit.upload(record_of(object), 2).number(), kOff);
    unit.device.on_frame(frame_to(server_of(object), 0x40, 0x1000), unit.now);
    EXPECT_TRUE(unit.bus.take().empty());
  }
}

TEST(SdoServers, ShowTheirOwnDriveObjectAndThreeObjects) {
  EightAxes unit;
  unit.switch_all_on();

  for (unsigned object = 1; object <= 9; ++object) {
    const SdoServerIds server = server_of(object);
    EXPECT_EQ(unit.upload(0x1000, 0, server).number(), 0xFFFF0192U);
    EXPECT_EQ(unit.upload(0x1001, 0, server).number(), 0U);
    EXPECT_EQ(unit.upload(0x1018, 1, server).number(), 0x06000053U);
    EXPECT_EQ(unit.upload(0x1018, 5, server).abort_code, kNoSubIndex);
    EXPECT_EQ(unit.upload(object_of(8612), 0, server).number(), server.request);
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x1008, 0x1017, 0x1201, 0x1400, 0x5800, 0x6041})
      EXPECT_EQ(unit.upload(index, 0, server).abort_code, kNoObject) << object << ": " << index;
    const bool is_axis = object > 1;
    EXPECT_EQ(unit.upload(object_of(1120), 0, server).abort_code, is_axis ? 0U : kNoObject);
    EXPECT_EQ(unit.upload(object_of(8630), 0, server).abort_code, is_axis ? kNoObject : 0U);
  }
}

TEST(SdoServers, IgnoreTheWindowOfTheDefaultServer) {
  EightAxes unit;
  unit.switch_on(3);
  ASSERT_EQ(unit.download(0x41B6, 0, 4, 2), 0U);
  ASSERT_EQ(unit.download(0x41B6, 1, 1, 2), 0U);

  ASSERT_EQ(ServerClient(unit, server_of(3)).download(object_of(8791), 0, 2, 2), 0U);

  EXPECT_EQ(unit.device.axis(2).read(8791).value(), 2.0);
  EXPECT_EQ(unit.device.axis(3).read(8791).value(), -1.0);
}

TEST(SdoServers, EndWithBit31) {
  EightAxes unit;
  unit.switch_on(2);

  ASSERT_EQ(unit.download(0x1202, 1, kOff, 4), 0U);

  unit.device.on_frame(frame_to(server_of(2), 0x40, 0x1000), unit.now);
  EXPECT_TRUE(unit.bus.take().empty());
  ASSERT_EQ(unit.download(0x1202, 1, 0x650, 4), 0U);
  EXPECT_EQ(unit.upload(0x1000, 0, {0x650, server_of(2).response}).number(), 0xFFFF0192U);
}

TEST(SdoServers, ChangeAValidIdentifierOnlyThroughAnInvalidOne) {
  EightAxes unit;
  unit.switch_on(1);

  EXPECT_EQ(unit.download(0x1201, 1, 0x650, 4), kDeviceState);
  EXPECT_EQ(unit.download(0x1201, 2, 0x5D0, 4), kDeviceState);
  EXPECT_EQ(unit.download(0x1201, 1, server_of(1).request, 4), 0U);
}

TEST(SdoServers, RefuseIdentifiersOutsideTheirRanges) {
  EightAxes unit;

  for (const std::uint32_t request : {0x600U, 0x680U, 0x581U, 0x301U, 0x20000610U, 0x40000610U})
    EXPECT_EQ(unit.download(0x1201, 1, request, 4), kInvalidValue) << std::hex << request;
  for (const std::uint32_t response : {0x580U, 0x600U, 0x601U, 0x301U})
    EXPECT_EQ(unit.download(0x1201, 2, response, 4), kInvalidValue) << std::hex << response;
  EXPECT_EQ(unit.upload(0x1201, 1).number(), kOff);
}

TEST(SdoServers, RefuseIdentifiersThatAreInUse) {
  EightAxes unit;
  unit.switch_on(2);

  EXPECT_EQ(unit.download(0x1201, 1, 0x605, 4), kCollision);
  EXPECT_EQ(unit.download(0x1201, 2, 0x585, 4), kCollision);
  EXPECT_EQ(unit.download(0x1203, 1, server_of(2).request, 4), kCollision);
  EXPECT_EQ(unit.download(0x1203, 2, server_of(2).response, 4), kCollision);
  EXPECT_EQ(unit.upload(0x1203, 2).number(), kOff);
}

TEST(SdoServers, AreParametersOfTheirDriveObjects) {
  EightAxes unit;
  ASSERT_EQ(unit.download(0x41B6, 0, 9, 2), 0U);

  EXPECT_EQ(unit.download(object_of(8612), 0, 0x605, 4), kCollision);
  EXPECT_EQ(unit.download(object_of(8612), 0, server_of(9).request, 4), 0U);
  EXPECT_EQ(unit.download(object_of(8612), 1, server_of(9).response, 4), 0U);

  EXPECT_EQ(unit.upload(0x1209, 1).number(), server_of(9).request);
  EXPECT_EQ(unit.upload(object_of(2), 0, server_of(9)).abort_code, 0U);
}

TEST(SdoServers, KeepNineTransfersApart) {
  EightAxes unit;
  unit.switch_all_on();
  const double time = 2.0;
  const auto ids_of = [](unsigned server) { return server == 0 ? SdoServerIds{} : server_of(server + 1); };
  const auto asks = [&](unsigned server, const canopen::Frame& frame) {
    unit.device.on_frame(frame, unit.now);
    const std::vector<canopen::Frame> answers = unit.bus.take();
    EXPECT_EQ(answers.size(), 1U) << server;
    EXPECT_EQ(answers.at(0).id, ids_of(server).response);
    return answers.at(0);
  };
  // The default server reads 1008h in segments, those of the axes write p1120 in a segment each.
  std::array<std::uint8_t, 8> segment{0x07};
  canopen::store(&segment[1], std::bit_cast<std::uint32_t>(static_cast<float>(time)));

  EXPECT_EQ(asks(0, frame_to(ids_of(0), 0x40, 0x1008)).data[0], 0x41);
  for (unsigned server = 1; server <= 8; ++server)
    EXPECT_EQ(asks(server, frame_to(ids_of(server), 0x21, object_of(1120), 4)).data[0], 0x60) << server;
  EXPECT_EQ(asks(0, frame_to(ids_of(0), 0x60, 0)).data,
            (std::array<std::uint8_t, 8>{0, 'S', 'I', 'N', 'A', 'M', 'I', 'C'}));
  for (unsigned server = 8; server >= 1; --server) {
    EXPECT_NE(unit.device.axis(server).read(1120).value(), time);
    EXPECT_EQ(asks(server, {.id = ids_of(server).request, .length = 8, .data = segment}).data[0], 0x20) << server;
    EXPECT_EQ(unit.device.axis(server).read(1120).value(), time);
  }
  EXPECT_EQ(asks(0, frame_to(ids_of(0), 0x70, 0)).data[1], 'S');
}

TEST(SdoServers, AnswerOnlyInPreOperationalAndOperational) {
  EightAxes unit;
  unit.switch_on(2);
  unit.says("000#0205");

  unit.device.on_frame(frame_to(server_of(2), 0x40, 0x1000), unit.now);

  EXPECT_TRUE(unit.bus.take().empty());
}

}  // namespace
}  // namespace device
