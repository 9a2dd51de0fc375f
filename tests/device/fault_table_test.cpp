#include "drive/fault_table.hpp"

#include "libcanopen/base/little_endian.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/fakes/fault_row_names.hpp"

namespace device {
namespace {

using drive::FaultRow;

class Messages : public testing::TestWithParam<FaultRow> {};

/// CAN alarms belong to the unit, drive object 1; everything else to the axis, drive object 2.
std::uint8_t drive_object(const FaultRow& row) {
  return row.kind == drive::Kind::Alarm && row.emcy_code != 0 ? 1 : 2;
}

Lines expected_emcy(const FaultRow& row) {
  if (row.emcy_code == 0) return {};
  canopen::Frame frame{.id = 0x085, .length = 8};
  canopen::store(&frame.data[0], row.emcy_code);
  frame.data[2] = row.error_register;
  canopen::store(&frame.data[3], row.number);
  frame.data[5] = drive_object(row);
  return {fakes::candump(frame)};
}

TEST_P(Messages, AreReportedAsTheirRowSays) {
  const FaultRow row = GetParam();
  TestUnit unit;
  unit.start();

  ASSERT_TRUE(unit.device.raise(1, row.number, 0, unit.now));

  const bool reported = row.emcy_code != 0;
  const std::uint64_t code = row.emcy_code;
  EXPECT_EQ(unit.passes(100ms), expected_emcy(row));
  EXPECT_EQ(unit.upload(0x1001).number(), row.error_register);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), reported ? 1U : 0U);
  EXPECT_EQ(unit.upload(0x1003, 1).number(), reported ? std::uint64_t{drive_object(row)} << 16 | code : 0U);
  const std::uint8_t block = drive_object(row) == 1 ? 0x4A : 0x02;  // count of the control unit, of the axis
  EXPECT_EQ(unit.upload(0x1003, block).number(), reported ? 1U : 0U);
  EXPECT_EQ(unit.upload(0x1003, static_cast<std::uint8_t>(block + 1)).number(),
            reported ? std::uint64_t{row.number} << 16 | code : 0U);
  EXPECT_EQ(unit.statusword() & 0x0088, row.kind == drive::Kind::Fault ? 0x0008 : 0x0080);
}

TEST_P(Messages, LeaveAsTheirRowSays) {
  const FaultRow row = GetParam();
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, row.number, 0, unit.now));
  unit.passes(100ms);

  const bool leaves = row.acknowledge != drive::Acknowledge::PowerOn;
  const Lines answer{"585#6003100000000000"};
  EXPECT_EQ(unit.says("605#2F03100000000000"),
            leaves && row.emcy_code != 0 ? (Lines{"085#0000000000000000", answer[0]}) : answer);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), leaves ? 0U : 1U);
  EXPECT_EQ(unit.statusword() & 0x0088, leaves ? 0 : 0x0008);
}

std::vector<FaultRow> messages_of_an_axis() {
  std::vector<FaultRow> rows;
  for (const FaultRow& row : drive::fault_rows())
    if (row.scope != drive::Scope::ControlUnit) rows.push_back(row);
  return rows;
}

INSTANTIATE_TEST_SUITE_P(Axis, Messages, testing::ValuesIn(messages_of_an_axis()),
                         [](const auto& row) { return drive::fault_text(row.param); });

TEST(MessagesOfTheControlUnit, AreNoneOfAnAxis) {
  TestUnit unit;
  unit.start();

  for (const FaultRow& row : drive::fault_rows()) {
    if (row.scope != drive::Scope::ControlUnit) continue;
    EXPECT_EQ(unit.device.raise(1, row.number, 0, unit.now), tl::unexpected{drive::FaultError::NotOnThisAxis});
  }
  EXPECT_EQ(unit.device.raise(1, 1, 0, unit.now), tl::unexpected{drive::FaultError::Unknown});
  EXPECT_EQ(unit.passes(100ms), Lines{});
}

}  // namespace
}  // namespace device
