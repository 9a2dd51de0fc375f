// Two devices without a node-ID on one bus, found by fastscan and told apart by their serial numbers (CiA 305).
#include <array>
#include <optional>

#include "libcanopen/base/little_endian.hpp"
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

/// A master of LSS and the devices on its bus.
struct LssBus {
  explicit LssBus(std::array<std::uint32_t, 2> serials)
      : devices{std::make_unique<TestDevice>(with(serials[0])), std::make_unique<TestDevice>(with(serials[1]))} {
    for (const auto& device : devices) EXPECT_EQ(device->start(), Lines{}) << "no boot-up";
  }
  static Configuration with(std::uint32_t serial) { return {.node_id = canopen::kNoNodeId, .serial = serial}; }

  /// What the devices answer to @p data.
  Lines asks(std::array<std::uint8_t, 8> data) {
    canopen::Frame frame{.id = 0x7E5, .length = 8, .data = data};
    Lines all;
    for (const auto& device : devices)
      for (const std::string& line : device->says(fakes::candump(frame))) all.push_back(line);
    return all;
  }
  bool scan(std::uint32_t number, std::uint8_t bit, std::uint8_t sub, std::uint8_t next) {
    std::array<std::uint8_t, 8> data{0x51};
    canopen::store(&data[1], number);
    data[5] = bit;
    data[6] = sub;
    data[7] = next;
    return !asks(data).empty();
  }
  /// Fastscan: the identity of a device that is in configuration state then; nothing if none is without node-ID.
  std::optional<std::array<std::uint32_t, 4>> find() {
    if (!scan(0, 0x80, 0, 0)) return std::nullopt;
    std::array<std::uint32_t, 4> identity{};
    for (std::uint8_t sub = 0; sub < 4; ++sub) {
      for (int bit = 31; bit >= 0; --bit)
        if (!scan(identity[sub], static_cast<std::uint8_t>(bit), sub, sub)) identity[sub] |= 1U << bit;
      if (!scan(identity[sub], 0, sub, static_cast<std::uint8_t>((sub + 1) % 4))) return std::nullopt;
    }
    return identity;
  }
  Lines configure(std::uint8_t node_id) {
    EXPECT_EQ(asks({0x11, node_id}), Lines{"7E4#1100000000000000"});
    return asks({0x04, 0x00});
  }

  std::array<std::unique_ptr<TestDevice>, 2> devices;
};

struct Fastscan : testing::TestWithParam<std::array<std::uint32_t, 2>> {};

TEST_P(Fastscan, FindsBothDevicesAndGivesThemNodeIds) {
  LssBus bus{GetParam()};
  std::array<std::uint32_t, 2> found{};
  for (std::uint8_t i = 0; i < 2; ++i) {
    const auto identity = bus.find();
    ASSERT_TRUE(identity);
    EXPECT_EQ((*identity)[0], 0U);
    EXPECT_EQ((*identity)[1], 0x402U);
    EXPECT_EQ((*identity)[2], 0x10000U);
    found[i] = (*identity)[3];
    const auto node_id = static_cast<std::uint8_t>(0x21 + i);
    const Lines sent = bus.configure(node_id);
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent.front(), i == 0 ? "721#00" : "722#00");
  }
  EXPECT_NE(found[0], found[1]);
  EXPECT_FALSE(bus.find()) << "nobody is left";
  for (const auto& device : bus.devices) EXPECT_NE(device->device.node_id(), canopen::kNoNodeId);
}

INSTANTIATE_TEST_SUITE_P(Serials, Fastscan,
                         testing::Values(std::array<std::uint32_t, 2>{1, 2},
                                         std::array<std::uint32_t, 2>{0x80000000, 0},
                                         std::array<std::uint32_t, 2>{0xFFFFFFFF, 0xFFFFFFFE}));

TEST(Lss, KeepsAStoredNodeIdOverThatOfTheConfiguration) {
  TestDevice device;
  device.start();
  for (const char* const request : {"7E5#4000000000000000", "7E5#4102040000000000", "7E5#4200000100000000"})
    EXPECT_EQ(device.says(request), Lines{});
  EXPECT_EQ(device.says("7E5#4301000000000000"), Lines{"7E4#4400000000000000"});
  EXPECT_EQ(device.says("7E5#1133000000000000"), Lines{"7E4#1100000000000000"});
  EXPECT_EQ(device.says("7E5#1700000000000000"), Lines{"7E4#1700000000000000"});
  EXPECT_EQ(device.device.node_id(), 5);
  TestDevice again;
  ASSERT_TRUE(again.device.load_parameters(device.listener.image));
  EXPECT_EQ(from("733#", again.start()), Lines{"733#00"});
}

}  // namespace
}  // namespace cia402
