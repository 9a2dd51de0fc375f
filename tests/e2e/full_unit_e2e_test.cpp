#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "tests/e2e/daemon_process.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/support/network.hpp"

namespace e2e {
namespace {

constexpr unsigned kAxes = 8, kOfAnAxis = 4, kTpdos = kAxes * kOfAnAxis;

/// TPDO @p place (0..3) of axis @p axis (0..7) of the unit below.
constexpr std::uint32_t identifier_of(unsigned axis, unsigned place) {
  return 0x185 + 0x100 * place + axis;
}

std::vector<std::uint32_t> identifiers() {
  std::vector<std::uint32_t> all;
  for (unsigned i = 0; i < kTpdos; ++i) all.push_back(identifier_of(i / kOfAnAxis, i % kOfAnAxis));
  return all;
}

/// Two controllers on one bus: can0 is the daemon's, can1 the master's. An emulated controller receives into a few
/// bytes and loses frames of a burst; a witness on can0 sees what the daemon's has sent.
struct FullUnit : testing::Test {
  static bool have_controllers() { return std::filesystem::exists("/sys/class/net/can0"); }
  static void set_up(const char* state) {
    for (const char* const name : {"can0", "can1"}) network::ip(std::string{"link set "} + name + ' ' + state);
  }
  static void SetUpTestSuite() {
    if (!have_controllers()) return;
    set_up("down");
    for (const char* const name : {"can0", "can1"})
      network::ip(std::string{"link set "} + name + " txqueuelen 10");  // as the kernel gives it
    set_up("up type can bitrate 1000000");
  }
  static void TearDownTestSuite() {
    if (have_controllers()) set_up("down");
  }
  void SetUp() override {
    if (have_controllers()) return;
    if (std::getenv("VCAN_VM") != nullptr) GTEST_FAIL() << "the virtual machine has no can0";
    GTEST_SKIP() << "no can0: a full bus is shown with the controllers of scripts/vcan-vm";
  }
};

/// An expedited download of @p size bytes to node 5.
canopen::Frame download(unsigned index, std::uint8_t sub_index, std::uint32_t value, unsigned size) {
  canopen::Frame frame{.id = 0x605, .length = 8};
  frame.data = {static_cast<std::uint8_t>(0x23U | (4 - size) << 2), static_cast<std::uint8_t>(index),
                static_cast<std::uint8_t>(index >> 8), sub_index};
  for (std::size_t i = 0; i < sizeof value; ++i) frame.data[4 + i] = static_cast<std::uint8_t>(value >> (8 * i));
  return frame;
}

/// The next SDO answer says that a download is done.
testing::AssertionResult is_done(CanClient& can) {
  return can.wait_until("585#60",
                        [](const canopen::Frame& frame) { return frame.id == 0x585 && frame.data[0] == 0x60; });
}

TEST_F(FullUnit, LosesNoneOf32TpdosOnAThousandSyncs) {
  DaemonProcess daemon{{.interface = "can0", .axes = kAxes}};
  CanClient master{"can1"};
  CanClient witness{"can0"};
  witness.listen_to(identifiers());
  ASSERT_TRUE(daemon.is_ready());
  for (unsigned axis = 0; axis < kAxes; ++axis)
    for (unsigned place = 0; place < kOfAnAxis; ++place) {
      const unsigned index = 0x1800 + 0x40 * axis + place;
      master.send(download(index, 2, 1, 1));
      ASSERT_TRUE(is_done(master));
      master.send(download(index, 1, 0x40000000U + identifier_of(axis, place), 4));
      ASSERT_TRUE(is_done(master)) << axis << ' ' << place;
    }
  master.send("000#0105");
  master.send("605#4000100000000000");
  ASSERT_TRUE(master.expect("585#430010009201FFFF"));

  witness.forget();
  constexpr int kSyncs = 1000;
  for (int sync = 0; sync < kSyncs; ++sync) {
    std::set<std::uint32_t> come;
    master.send("080#");
    ASSERT_TRUE(witness.wait_until("the TPDOs of SYNC " + std::to_string(sync), [&](const canopen::Frame& frame) {
      come.insert(frame.id);
      return come.size() == kTpdos;
    })) << come.size();
  }

  EXPECT_EQ(daemon.bus_counter("replaced"), 0U);
  EXPECT_EQ(daemon.bus_counter("send_dropped"), 0U);
}

}  // namespace
}  // namespace e2e
