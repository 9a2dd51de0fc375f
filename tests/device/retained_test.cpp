#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

TEST(Retained, BringsFaultBuffersEnergiesAndRuntimeBack) {
  TestUnit unit;
  unit.turn_at(600, 8s);
  unit.passes(1s);
  ASSERT_TRUE(unit.device.raise(1, 7860, 42, unit.now));
  const double drawn = unit.device.axis().read(39, 1).value();
  ASSERT_GT(drawn, 0.0);
  const auto kept = unit.device.retained(unit.now);

  TestUnit next;
  ASSERT_TRUE(next.device.load_retained(kept));
  next.start();

  EXPECT_EQ(next.device.axis().read(945, 8).value(), 7860.0);
  EXPECT_EQ(next.device.axis().read(949, 8).value(), 42.0);
  EXPECT_EQ(next.device.axis().read(39, 1).value(), drawn);
  EXPECT_EQ(next.device.unit().runtime(), unit.device.unit().runtime());
  EXPECT_EQ(next.upload(0x1001).number(), 0U);
  EXPECT_EQ(next.statusword() & 0x4F, 0x40);
}

TEST(Retained, TellsWhenThereIsSomethingToKeep) {
  TestUnit unit;
  unit.start();
  unit.passes(1s);
  const std::uint32_t before = unit.device.message_changes();
  EXPECT_FALSE(unit.device.is_moving());
  unit.passes(60s);
  EXPECT_EQ(unit.device.message_changes(), before);

  ASSERT_TRUE(unit.device.raise(1, 7860, 42, unit.now));
  const std::uint32_t raised = unit.device.message_changes();
  EXPECT_NE(raised, before);
  unit.device.acknowledge(1, unit.now);

  EXPECT_NE(unit.device.message_changes(), raised);
}

TEST(Retained, TellsWhenAnAxisMoves) {
  TestUnit unit;
  unit.turn_at(600, 8s);
  EXPECT_TRUE(unit.device.is_moving());

  unit.says("205#0000");
  unit.passes(100ms);
  EXPECT_TRUE(unit.device.is_moving()) << "it coasts";
  unit.passes(10min);

  EXPECT_FALSE(unit.device.is_moving());
}

TEST(Retained, CountsNoTimeBeforeTheStart) {
  TestUnit unit;

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.device.retained(unit.now);

  EXPECT_EQ(unit.device.unit().runtime(), 0U);
}

}  // namespace
}  // namespace device
