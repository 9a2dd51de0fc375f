#include "unit/parameter_storage.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/shelf.hpp"

namespace unit {
namespace {

using drive::Refusal;

constexpr std::uint8_t kControlUnit = 1;
constexpr std::uint8_t kX = 2;
constexpr std::uint8_t kY = 3;

/// A unit of two axes with its saved parameters.
struct Storage : testing::Test {
  static drive::UnitConfiguration two_axes() { return {.axes = {{}, {}}, .node_id = 5}; }

  /// Writes a command: nothing, or the reason of its refusal.
  std::optional<Refusal> command(std::uint8_t object, std::uint16_t number, double value) {
    const auto written = unit.object(object)->write(number, value);
    return written ? std::nullopt : std::optional{written.error().reason};
  }
  bool has_follow_up() const { return !follow_ups.is_empty(); }
  /// What is to be done next after the answer, if anything is.
  std::optional<FollowUps<FollowUp>::Item> next() {
    return has_follow_up() ? std::optional{follow_ups.take()} : std::nullopt;
  }
  static FollowUps<FollowUp>::Item restore_of(ParameterGroup group) {
    return {FollowUp::Restore, static_cast<std::uint8_t>(group)};
  }
  static constexpr FollowUps<FollowUp>::Item kReset{FollowUp::Reset, 0};
  double value(std::uint8_t object, std::uint16_t number) const {
    return unit.object(object)->read(number).value();
  }
  /// The value after the next power-on.
  double saved_value(std::uint8_t object, std::uint16_t number) const {
    drive::DriveUnit next{two_axes()};
    EXPECT_TRUE(drive::storage_image::load(next, shelf.image));
    return next.object(object)->read(number).value();
  }

  Storage() { name_groups(storage); }
  static void name_groups(ParameterStorage& of) {
    of.groups().define(ParameterGroup::Communication, [](const drive::ParameterRow& row) noexcept {
      return row.number == 8606 || row.number == 8701;
    });
    of.groups().define(ParameterGroup::Application, [](const drive::ParameterRow& row) noexcept {
      return row.number == 1120 || row.number == 1135;
    });
  }

  FollowUps<FollowUp> follow_ups;
  UnitParameters parameters;
  drive::DriveUnit unit{two_axes(), &parameters};
  Shelf shelf;
  ParameterStorage storage{unit, parameters, shelf, follow_ups};
};

TEST_F(Storage, SavesEveryDriveObjectOnP0977) {
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  ASSERT_TRUE(unit.object(kY)->write(1120, 2.0));
  ASSERT_TRUE(unit.object(kControlUnit)->write(8699, 3.0));

  EXPECT_EQ(command(kControlUnit, 977, 1), std::nullopt);

  EXPECT_EQ(saved_value(kX, 1120), 1.0);
  EXPECT_EQ(saved_value(kY, 1120), 2.0);
  EXPECT_EQ(saved_value(kControlUnit, 8699), 3.0);
  EXPECT_EQ(value(kControlUnit, 977), 0.0);
}

TEST_F(Storage, SavesOneDriveObjectOnItsP0971) {
  ASSERT_EQ(command(kControlUnit, 977, 1), std::nullopt);
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  ASSERT_TRUE(unit.object(kY)->write(1120, 2.0));

  EXPECT_EQ(command(kY, 971, 1), std::nullopt);

  EXPECT_EQ(saved_value(kX, 1120), 10.0);
  EXPECT_EQ(saved_value(kY, 1120), 2.0);
  EXPECT_EQ(value(kY, 971), 0.0);
}

TEST_F(Storage, SavesDriveObjectsOneByOneBeforeAllWereSaved) {
  ASSERT_TRUE(unit.object(kY)->write(1120, 2.0));
  ASSERT_EQ(command(kY, 971, 1), std::nullopt);
  EXPECT_EQ(storage.store(ParameterGroup::Application), Refusal{Refusal::NotNow});

  ASSERT_EQ(command(kX, 971, 1), std::nullopt);
  ASSERT_EQ(command(kControlUnit, 971, 1), std::nullopt);

  EXPECT_EQ(saved_value(kY, 1120), 2.0);
  EXPECT_EQ(storage.store(ParameterGroup::Application), std::nullopt);
}

/// A07441 stands until the offset of an adjusted absolute encoder is saved.
TEST(StorageOfAnAdjustment, TellsTheAxis) {
  drive::AxisConfiguration axis{.positioner = true};
  axis.machine.encoder.type = motor::EncoderType::Absolute;
  FollowUps<FollowUp> follow_ups;
  UnitParameters parameters;
  drive::DriveUnit unit{{.axes = {axis}, .node_id = 5}, &parameters};
  Shelf shelf;
  ParameterStorage storage{unit, parameters, shelf, follow_ups};
  const auto run = [&] {
    for (int i = 0; i < 3; ++i) unit.cycle(std::array{true}, 1e-3);
  };
  const drive::ActualPosition& position = unit.axes()[0].block<drive::ActualPosition>();
  run();
  ASSERT_TRUE(unit.object(kX)->write(2599, 1000.0));
  ASSERT_TRUE(unit.object(kX)->write(2507, 2.0));
  run();
  EXPECT_TRUE(position.adjustment_unsaved());

  ASSERT_TRUE(unit.object(kControlUnit)->write(977, 1.0));

  EXPECT_FALSE(position.adjustment_unsaved());
}

TEST_F(Storage, DoesNothingOnZero) {
  ASSERT_EQ(command(kControlUnit, 9, 30), std::nullopt);
  for (const std::uint16_t number : std::vector<std::uint16_t>{971, 972, 976, 977})
    EXPECT_EQ(command(kControlUnit, number, 0), std::nullopt);

  EXPECT_EQ(shelf.stores, 0);
  EXPECT_FALSE(has_follow_up());
}

TEST_F(Storage, RefusesOtherValues) {
  EXPECT_EQ(command(kControlUnit, 977, 2), Refusal{Refusal::IllegalValue});
  EXPECT_EQ(command(kControlUnit, 977, 1013), Refusal{Refusal::IllegalValue});
  ASSERT_EQ(command(kControlUnit, 9, 30), std::nullopt);
  EXPECT_EQ(command(kControlUnit, 976, 3), Refusal{Refusal::IllegalValue});

  EXPECT_EQ(shelf.stores, 0);
  EXPECT_FALSE(has_follow_up());
}

TEST_F(Storage, SavesOneGroupOfEveryDriveObject) {
  ASSERT_EQ(storage.store(ParameterGroup::All), std::nullopt);
  for (const std::uint8_t axis : {kX, kY}) {
    ASSERT_TRUE(unit.object(axis)->write(1120, 1.0));
    ASSERT_TRUE(unit.object(axis)->write(2161, 7.0));
    ASSERT_TRUE(unit.object(axis)->write(8701, 0, 0x345));
  }
  ASSERT_TRUE(unit.object(kControlUnit)->write(8606, 250));

  ASSERT_EQ(storage.store(ParameterGroup::Communication), std::nullopt);
  EXPECT_EQ(saved_value(kX, 8701), 0x345);
  EXPECT_EQ(saved_value(kControlUnit, 8606), 250.0);
  EXPECT_EQ(saved_value(kX, 1120), 10.0);

  ASSERT_EQ(storage.store(ParameterGroup::Application), std::nullopt);
  EXPECT_EQ(saved_value(kX, 1120), 1.0);
  EXPECT_EQ(saved_value(kY, 1120), 1.0);
  EXPECT_EQ(saved_value(kX, 2161), 5.0);
}

TEST_F(Storage, StaysAsItWasWhenNobodyKeepsTheImage) {
  ASSERT_EQ(storage.store(ParameterGroup::All), std::nullopt);
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  shelf.is_full = true;

  EXPECT_EQ(storage.store(ParameterGroup::All), Refusal{Refusal::Failed});
  EXPECT_EQ(storage.store(ParameterGroup::Application), Refusal{Refusal::Failed});
  EXPECT_EQ(command(kControlUnit, 977, 1), Refusal{Refusal::Failed});
  EXPECT_EQ(command(kX, 971, 1), Refusal{Refusal::Failed});
  storage.reload(ParameterGroup::All);

  EXPECT_EQ(value(kX, 1120), 10.0);
}

TEST_F(Storage, ReloadsWhatWasSavedAndForgetsTheRest) {
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  ASSERT_TRUE(unit.object(kControlUnit)->write(8606, 250));
  ASSERT_EQ(storage.store(ParameterGroup::All), std::nullopt);
  ASSERT_TRUE(unit.object(kX)->write(1120, 2.0));
  ASSERT_TRUE(unit.object(kY)->write(1121, 2.0));
  ASSERT_TRUE(unit.object(kControlUnit)->write(8606, 500));
  ASSERT_TRUE(unit.object(kControlUnit)->write(8622, 3));
  ASSERT_TRUE(unit.object(kX)->write(10, 1));

  storage.reload(ParameterGroup::Communication);
  EXPECT_EQ(value(kControlUnit, 8606), 250.0);
  EXPECT_EQ(value(kX, 1120), 2.0);
  EXPECT_EQ(value(kX, 10), 1.0);

  storage.reload(ParameterGroup::All);
  EXPECT_EQ(value(kX, 1120), 1.0);
  EXPECT_EQ(value(kY, 1121), 10.0);
  EXPECT_EQ(value(kX, 10), 0.0);
  EXPECT_EQ(value(kControlUnit, 8622), 6.0);
}

TEST_F(Storage, KeepsTheBitRateThroughAReset) {
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  ASSERT_TRUE(unit.object(kControlUnit)->write(8622, 3));
  ASSERT_TRUE(unit.object(kControlUnit)->write(8623, 1, 7.0));
  ASSERT_TRUE(unit.object(kControlUnit)->write(9, 30));

  storage.reset(ParameterGroup::All);

  EXPECT_EQ(value(kX, 1120), 10.0);
  EXPECT_EQ(value(kControlUnit, 9), 0.0);
  EXPECT_EQ(value(kControlUnit, 8620), 5.0);
  EXPECT_EQ(value(kControlUnit, 8622), 3.0);
  EXPECT_EQ(unit.object(kControlUnit)->read(8623, 1).value(), 7.0);
}

TEST_F(Storage, AdoptsAnImageAndGoesOnFromIt) {
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  ASSERT_EQ(storage.store(ParameterGroup::All), std::nullopt);
  drive::DriveUnit next{two_axes()};
  UnitParameters none;
  ParameterStorage adopted{next, none, shelf, follow_ups};
  name_groups(adopted);

  ASSERT_TRUE(adopted.adopt(std::vector<std::byte>{shelf.image}));
  EXPECT_EQ(next.object(kX)->read(1120).value(), 1.0);
  ASSERT_TRUE(next.object(kY)->write(1135, 4.0));
  ASSERT_EQ(adopted.store(ParameterGroup::Application), std::nullopt);

  EXPECT_EQ(saved_value(kX, 1120), 1.0);
  EXPECT_EQ(saved_value(kY, 1135), 4.0);
}

TEST_F(Storage, AdoptsNothingOfAnImageThatDoesNotFit) {
  const std::vector<std::byte> garbage(100, std::byte{0x55});

  EXPECT_EQ(storage.adopt(garbage).error(), ParameterStorage::Error::NotAnImage);

  EXPECT_EQ(storage.store(ParameterGroup::Communication), Refusal{Refusal::NotNow});
}

TEST_F(Storage, NotesWhatIsToBeDoneAfterTheAnswer) {
  ASSERT_EQ(command(kControlUnit, 9, 30), std::nullopt);
  EXPECT_EQ(command(kControlUnit, 976, 1), std::nullopt);
  EXPECT_EQ(next(), restore_of(ParameterGroup::All));
  EXPECT_FALSE(has_follow_up());
  EXPECT_EQ(command(kControlUnit, 976, 2), std::nullopt);
  EXPECT_EQ(next(), kReset);
  EXPECT_EQ(command(kControlUnit, 972, 1), std::nullopt);
  EXPECT_EQ(next(), kReset);
  EXPECT_EQ(value(kControlUnit, 972), 0.0);
  for (const ParameterGroup group :
       {ParameterGroup::All, ParameterGroup::Communication, ParameterGroup::Application}) {
    ASSERT_EQ(storage.restore(group), std::nullopt);
    EXPECT_EQ(next(), restore_of(group));
  }
}

TEST_F(Storage, RestartsWhenOperationalIsLeftIfP0972SaysSo) {
  storage.on_operational_left();
  EXPECT_FALSE(has_follow_up());
  ASSERT_EQ(command(kControlUnit, 972, 2), std::nullopt);
  EXPECT_EQ(value(kControlUnit, 972), 2.0);
  storage.on_operational_left();
  EXPECT_FALSE(has_follow_up());

  ASSERT_EQ(command(kControlUnit, 972, 3), std::nullopt);
  EXPECT_EQ(value(kControlUnit, 972), 3.0);
  storage.on_operational_left();

  EXPECT_EQ(next(), kReset);
  storage.reload(ParameterGroup::All);
  EXPECT_EQ(value(kControlUnit, 972), 0.0);
}

TEST_F(Storage, RefusesToRestoreWhilePulsesAreEnabled) {
  for (const std::uint16_t controlword : std::vector<std::uint16_t>{0x0, 0x6, 0x7, 0xF})
    for (int i = 0; i < 3; ++i) unit.axes()[1].cycle(drive::Setpoints{.controlword = controlword}, 0.004);
  ASSERT_TRUE(unit.axes()[1].actual().pulses_enabled);

  for (const ParameterGroup group :
       {ParameterGroup::All, ParameterGroup::Communication, ParameterGroup::Application})
    EXPECT_EQ(storage.restore(group), Refusal{Refusal::NotNow});
  ASSERT_EQ(command(kControlUnit, 9, 30), std::nullopt);
  EXPECT_EQ(command(kControlUnit, 976, 1), Refusal{Refusal::NotNow});

  EXPECT_FALSE(has_follow_up());
  EXPECT_EQ(storage.store(ParameterGroup::All), std::nullopt);
}

}  // namespace
}  // namespace unit
