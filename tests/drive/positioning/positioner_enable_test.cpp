// Enable and tracking of the basic positioner: p2655, p2656, OFF1 to OFF3.
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr int kEnableWithdrawn = 7490;

struct Start {
  const char* name;
  double code;  // r2669
  void (*begin)(PositioningUnit&);
};
const std::array kStarts{
    Start{"jog", 1.0, [](PositioningUnit& unit) { unit.set(2590, 1.0); }},
    Start{"search", 2.0, [](PositioningUnit& unit) { unit.set(2595, 1.0); }},
    Start{"block", 4.0, [](PositioningUnit& unit) { unit.start_block(1); }},
    Start{"MDI", 8.0, [](PositioningUnit& unit) { unit.move(500000.0, 600.0); }},
};

struct Loss {
  const char* name;
  void (*happens)(PositioningUnit&);
  void (*is_over)(PositioningUnit&);
};
const std::array kLosses{
    Loss{"OFF1", [](PositioningUnit& unit) { unit.control(0x0006); }, [](PositioningUnit&) {}},
    Loss{"OFF2", [](PositioningUnit& unit) { unit.control(0x000D); }, [](PositioningUnit&) {}},
    Loss{"OFF3", [](PositioningUnit& unit) { unit.control(0x000B); }, [](PositioningUnit&) {}},
    Loss{"p2656", [](PositioningUnit& unit) { unit.set(2656, 0.0); },
         [](PositioningUnit& unit) {
           unit.wire(2656, {2526, kOwnObject, 3});
         }},
};

void prepare(PositioningUnit& unit) {
  unit.enable();
  unit.set_reference();
  unit.block(0, {.number = 1, .task = 3, .velocity = 600.0});
  unit.run(2);
}

/// Offset p2516, in PZD 5 and 6: the axis stands elsewhere.
void displace(PositioningUnit& unit, std::uint32_t by) {
  ProcessDataImage::set_double_word(unit.axis().process_data().received, 4, by);
  unit.wire(2516, {8860, kOwnObject, 4});
}

TEST(PositionerEnable, LosingItWhileATaskRunsIsAFault) {
  for (const Start& start : kStarts) {
    for (const Loss& loss : kLosses) {
      SCOPED_TRACE(std::string{start.name} + ", " + loss.name);
      PositioningUnit unit;
      prepare(unit);
      start.begin(unit);
      unit.run(200);
      ASSERT_EQ(unit.read(2669), start.code);
      loss.happens(unit);
      unit.run(10);
      EXPECT_TRUE(unit.has(kEnableWithdrawn));
      EXPECT_EQ(unit.read(2669), 0.0);
      EXPECT_FALSE(unit.bit(2684, 15));
      ASSERT_TRUE(unit.run_until([&] { return std::abs(unit.read(21)) < 0.5; }, 5000));
      unit.run(100);
      EXPECT_NEAR(unit.read(2665), unit.read(2521), 1.0) << "tracking";
      EXPECT_TRUE(unit.bit(2683, 0));
      for (const std::uint16_t input : std::initializer_list<std::uint16_t>{2590, 2595, 2647, 2631})
        unit.set(input, 0.0);
      loss.is_over(unit);
      unit.acknowledge();
      unit.run(5);
      EXPECT_FALSE(unit.has(kEnableWithdrawn));
      unit.enable();
      unit.set(2589, 1.0);
      unit.run(5);
      EXPECT_EQ(unit.read(2669), 1.0) << "goes on after all";
    }
  }
}

TEST(PositionerEnable, LosingItBrakesWithTheRampOfTheReaction) {
  constexpr double kSpeed = 600.0;  // rpm, at 6000 * 1000 LU/min
  for (const Loss& loss : kLosses) {
    if (loss.name == std::string{"OFF2"} || loss.name == std::string{"OFF3"}) continue;
    SCOPED_TRACE(loss.name);
    PositioningUnit unit;
    prepare(unit);
    unit.set(1121, 10.0);
    unit.move(500000.0, 6000.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.read(2666) == 6000.0; }, 3000));
    unit.run(100);
    loss.happens(unit);
    for (int i = 0; i < 20; ++i) {
      unit.run(1);
      ASSERT_GT(unit.axis().actual().speed / kRpm, 0.95 * kSpeed) << i;
    }
    ASSERT_TRUE(unit.run_until([&] { return unit.read(21) < 0.5 * kSpeed; }, 10000));
  }
}

TEST(PositionerEnable, OffAtRestIsNoFault) {
  for (const Loss& loss : kLosses) {
    SCOPED_TRACE(loss.name);
    PositioningUnit unit;
    prepare(unit);
    unit.move(2000.0, 600.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }, 3000));
    loss.happens(unit);
    unit.run(100);
    EXPECT_TRUE(unit.messages().empty());
    EXPECT_EQ(unit.read(2669), 0.0);
    EXPECT_TRUE(unit.bit(2684, 11)) << "the reference stays";
  }
}

TEST(PositionerEnable, AFaultOfTheAxisIsTheOnlyOne) {
  PositioningUnit unit;
  prepare(unit);
  unit.move(500000.0, 600.0);
  unit.run(200);
  unit.set(2106, 0.0);  // external fault 1
  unit.run(50);
  EXPECT_EQ(unit.messages(), std::vector{7860});
  EXPECT_EQ(unit.read(2669), 0.0);
}

TEST(PositionerEnable, AStartWithoutItIsRefused) {
  for (const Start& start : kStarts) {
    SCOPED_TRACE(start.name);
    PositioningUnit unit;
    unit.set_reference();
    unit.block(0, {.number = 1, .task = 3});
    unit.set(2625, 1.0);
    unit.set(2631, start.code == 4.0 ? 1.0 : 0.0);
    unit.set(2647, start.code == 8.0 ? 1.0 : 0.0);
    unit.set(2650, start.code == 8.0 ? 1.0 : 0.0);
    if (start.code < 4.0) start.begin(unit);
    unit.run(5);
    EXPECT_EQ(unit.value_of(7496), 1) << "p2656";
    EXPECT_EQ(unit.read(2669), 0.0);
    for (const std::uint16_t input : std::initializer_list<std::uint16_t>{2590, 2595, 2631, 2650})
      unit.set(input, 0.0);
    unit.run(2);
    EXPECT_FALSE(unit.has(7496));
  }
}

TEST(PositionerEnable, AStartWithoutAPositionIsRefused) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2658, 0.0);
  unit.run(3);
  unit.set(2590, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.value_of(7496), 2);
}

TEST(PositionerEnable, TheSetpointTracksOrStays) {
  PositioningUnit unit;
  prepare(unit);
  unit.move(2000.0, 600.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }, 3000));
  unit.run(500);
  EXPECT_FALSE(unit.bit(2683, 0));
  unit.disable();
  unit.run(20);
  EXPECT_TRUE(unit.bit(2683, 0));
  unit.enable();
  unit.run(2);
  EXPECT_FALSE(unit.bit(2683, 0));
  unit.set(2655, 0.0, 0);
  unit.set(2655, 0.0, 1);
  unit.disable();
  unit.run(20);
  EXPECT_FALSE(unit.bit(2683, 0)) << "nothing asks for tracking";
  displace(unit, 30);
  unit.run(20);
  EXPECT_EQ(unit.read(2665), 2000.0);
  EXPECT_NEAR(unit.read(2521), 2030.0, 2.0);
  unit.enable();
  unit.run(500);
  EXPECT_NEAR(unit.read(2521), 2000.0, 2.0) << "back to the setpoint";
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerEnable, TracksUntilTheFirstEnable) {
  PositioningUnit unit;
  unit.set(2655, 0.0, 0);
  unit.set(2655, 0.0, 1);
  displace(unit, 500);
  unit.run(3);
  EXPECT_TRUE(unit.bit(2683, 0));
  EXPECT_EQ(unit.read(2665), 500.0);
}

TEST(PositionerEnable, JogOfTheSetpointChannelKeepsItsOwnWay) {
  PositioningUnit unit;
  unit.set(1058, 100.0);
  unit.control(0x0006);
  unit.control(0x000E);
  unit.set(1055, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(21) > 95.0; }, 20000));
  EXPECT_FALSE(unit.bit(2526, 3));
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_TRUE(unit.bit(2683, 0));
  unit.set(1055, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(21) < 0.5; }, 20000));
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerEnable, JogOfTheSetpointChannelIsWithoutEffectInPositionControl) {
  PositioningUnit unit;
  prepare(unit);
  unit.set(1058, 100.0);
  unit.set(1055, 1.0);
  unit.run(500);
  EXPECT_EQ(unit.read(2665), 0.0);
  EXPECT_NEAR(unit.read(2521), 0.0, 2.0);
  EXPECT_TRUE(unit.bit(2526, 3));
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerEnable, ModesOfOperationAsProcessDataChangeNothing) {
  for (const std::int8_t mode : std::initializer_list<std::int8_t>{4, 2}) {
    PositioningUnit unit;
    prepare(unit);
    unit.move(100000.0, 600.0);
    unit.run(200);
    unit.axis().process_data().requested_mode = mode;
    unit.run(100);
    EXPECT_TRUE(unit.bit(2526, 3));
    EXPECT_EQ(unit.read(2666), 600.0);
    EXPECT_EQ(unit.axis().actual().mode, 3) << "6061h";
    EXPECT_TRUE(unit.messages().empty());
  }
}

}  // namespace
}  // namespace drive
