#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using SyncConsumer = NodeTest;

constexpr std::string_view kTpdo2 = "285#400000000000";

TEST_F(SyncConsumer, TakesFramesWithAndWithoutACounter) {
  start_operational();
  says("080#");

  EXPECT_EQ(says("080#"), (Lines{std::string{kTpdo2}}));
  EXPECT_EQ(says("080#07"), (Lines{std::string{kTpdo2}}));
}

TEST_F(SyncConsumer, IgnoresFramesThatAreNoSync) {
  start_operational();

  EXPECT_EQ(says("080#0000"), (Lines{"085#4082110200000000"})) << "two bytes: nothing but a complaint";
  EXPECT_EQ(says("080#R"), Lines{});
  EXPECT_EQ(says("00000080#"), Lines{});
}

TEST_F(SyncConsumer, HasNoEffectOutsideOperational) {
  start();

  EXPECT_EQ(says("080#"), Lines{});
  says("000#0205");
  EXPECT_EQ(says("080#"), Lines{});
}

TEST_F(SyncConsumer, FollowsItsCobId) {
  start_operational();
  says("080#");
  const int before = application.subscription_changes;

  EXPECT_EQ(writes_u32(0x1005, 0, 0x90), 0U);

  EXPECT_EQ(application.subscription_changes, before + 1);
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x90, 0x205, 0x305, 0x405, 0x585, 0x605, 0x705}));
  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(says("090#"), (Lines{std::string{kTpdo2}}));
}

TEST_F(SyncConsumer, JudgesItsCobId) {
  struct Row {
    std::uint32_t cob_id, abort;
  };
  const Row rows[] = {
      {0x00000080, 0},          {0x80000080, 0},  // bit 31 has no meaning
      {0x40000080, 0x06090030},                   // would produce
      {0x20000080, 0x06090030},                   // 29 bits
      {0x00000880, 0x06090030}, {0x00000000, 0x06090030}, {0x00000605, 0x06090030},
      {0x00000180, 0x06090030}, {0x00000205, 0x06040043},  // RPDO 1
      {0x00000185, 0x06040043},                            // TPDO 1
      {0x00000085, 0x06040043},                            // EMCY
      {0x000000FF, 0},
  };
  start();

  for (const Row& row : rows) EXPECT_EQ(writes_u32(0x1005, 0, row.cob_id), row.abort) << std::hex << row.cob_id;
}

}  // namespace
