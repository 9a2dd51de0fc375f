#include "drive/messages/fault_memory.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "tests/e2e/daemon_process.hpp"
#include "tests/fakes/candump.hpp"

namespace e2e {
namespace {

using drive::FaultRow;

/// Every row of the fault table injected with axisctl; what each does in detail is shown without a bus
/// (tests/device/fault_table_test.cpp).
struct Messages : RunningDaemon {
  static void SetUpTestSuite() { start({.axes = 2}); }

  static constexpr std::uint32_t kValue = 2;  // of F08700: life guarding
  static std::uint16_t code(const FaultRow& row) {
    return drive::FaultEntry{.row = &row, .value = kValue, .kind = row.kind}.emcy_code();
  }
  /// The drive object numbers of the EMCY that @p row sends when it comes from axis 1, the origin first.
  static std::vector<std::uint8_t> reported(const FaultRow& row) {
    if (code(row) == 0) return {};
    if (row.kind == drive::Kind::Alarm) return {1};
    const std::uint8_t origin = row.scope == drive::Scope::ControlUnit ? 1 : 2;
    std::vector<std::uint8_t> objects{origin};
    if (row.propagation == drive::Propagation::Local) return objects;
    for (std::uint8_t object = 1; object <= 3; ++object)
      if (object != origin) objects.push_back(object);
    return objects;
  }
  static std::string emcy(const FaultRow& row, std::uint8_t object) {
    canopen::Frame frame{.id = 0x085, .length = 8};
    canopen::store(&frame.data[0], code(row));
    frame.data[2] = row.error_register;
    canopen::store(&frame.data[3], row.number);
    frame.data[5] = object;
    return fakes::candump(frame);
  }
};

TEST_F(Messages, AreInjectedAndAcknowledgedOneByOne) {
  can->listen_to({0x085, 0x705});
  unsigned messages = 0;
  for (const FaultRow& row : drive::fault_rows()) {
    SCOPED_TRACE(drive::fault_text(row));
    const std::string axis = row.scope == drive::Scope::ControlUnit ? "0" : "1";
    const std::string value = std::to_string(kValue);
    ASSERT_EQ(daemon->axisctl({"fault", "inject", axis, drive::fault_text(row), value}).status, 0);
    const auto objects = reported(row);
    for (const std::uint8_t object : objects) ASSERT_TRUE(can->expect(emcy(row, object)));

    const bool stays = row.acknowledge == drive::Acknowledge::PowerOn;
    const bool spreads = row.propagation == drive::Propagation::Global;
    for (const std::string& place : spreads ? std::vector<std::string>{"0", "1", "2"} : std::vector{axis}) {
      const auto acknowledged = daemon->axisctl({"fault", "ack", place});
      EXPECT_EQ(acknowledged.status, stays && axis == place ? 3 : 0) << acknowledged.errors;
    }
    if (stays) {
      can->send("000#8105");
      ASSERT_TRUE(can->expect("705#00"));
    } else if (!objects.empty()) {
      ASSERT_TRUE(can->expect("085#0000000000000000"));
    }
    ++messages;
  }
  std::cout << messages << " messages\n";
}

struct ActiveMessages : RunningDaemon {
  static void SetUpTestSuite() { start(); }
};

TEST_F(ActiveMessages, OutliveAResetOfTheCommunicationUntilTheyAreAcknowledged) {
  can->listen_to({0x085, 0x585, 0x705});
  ASSERT_EQ(daemon->axisctl({"fault", "inject", "1", "F07860"}).status, 0);
  ASSERT_TRUE(can->expect("085#001081B41E020000"));

  can->send("000#8205");
  ASSERT_TRUE(can->expect("705#00"));

  EXPECT_TRUE(can->ask("605#4001100000000000", "585#4F01100081000000"));
  EXPECT_TRUE(can->ask("605#4003100300000000", "585#430310030010B41E"));
  can->send("605#2F03100000000000");
  EXPECT_TRUE(can->expect("085#0000000000000000"));
  EXPECT_TRUE(can->expect("585#6003100000000000"));
  EXPECT_TRUE(can->ask("605#4003100000000000", "585#4F03100000000000"));
}

}  // namespace
}  // namespace e2e
