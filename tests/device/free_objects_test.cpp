#include <cmath>

#include "drive/parameter/bico.hpp"
#include "tests/device/process_data_unit.hpp"
#include "tests/device/test_unit.hpp"

namespace device {
namespace {

TEST(FreeObjects, ShowWhatTheirInputsAreConnectedToWhileTheyAreNotMapped) {
  ProcessDataUnit unit{1};
  unit.start();
  const double torque = unit.parameter(2, 1520) / unit.parameter(2, 2003);  // p1520 against its reference
  EXPECT_EQ(unit.read(0x5810), 0) << "not connected";

  ASSERT_TRUE(unit.set_parameter(2, 8746, 0, 1.0));
  ASSERT_TRUE(unit.set_parameter(2, 8748, 0, 1.0));
  ASSERT_TRUE(unit.set_parameter(2, 8746, 15, drive::own_source(1521, 0)));
  ASSERT_TRUE(unit.set_parameter(2, 8748, 7, drive::own_source(1520, 0)));
  EXPECT_EQ(unit.read(0x5810), 0x4000) << "100 %";
  EXPECT_EQ(unit.read(0x5830), 0x40000000) << "100 %";
  EXPECT_EQ(unit.read(0x581F),
            std::max(-32768L, std::lround(unit.parameter(2, 1521) / unit.parameter(2, 2003) * 0x4000)));
  EXPECT_EQ(unit.read(0x5837), std::min(2147483647L, std::lround(torque * 0x40000000)));
}

TEST(FreeObjects, TakeWordsAsTheyAreAndProcessDataByTheirPercentage) {
  ProcessDataUnit unit{2};
  unit.start();
  ASSERT_EQ(unit.write(0x5880, 0, 0x1234), 0U);      // of axis 2
  ASSERT_EQ(unit.write(0x58A7, 0, 0x12345678), 0U);  // likewise
  ASSERT_TRUE(unit.set_parameter(2, 8746, 1, drive::pack({8745, 3, 0})));
  ASSERT_TRUE(unit.set_parameter(2, 8746, 2, drive::pack({8747, 3, 7})));
  ASSERT_TRUE(unit.set_parameter(2, 8748, 1, drive::pack({8745, 3, 0})));
  ASSERT_TRUE(unit.set_parameter(2, 8748, 2, drive::pack({8747, 3, 7})));
  ASSERT_TRUE(unit.set_parameter(2, 8748, 3, drive::own_source(2, 0)));

  EXPECT_EQ(unit.read(0x5811), 0x1234);
  EXPECT_EQ(unit.read(0x5812), 0x1234) << "rounded";
  EXPECT_EQ(unit.read(0x5831), 0x12340000);
  EXPECT_EQ(unit.read(0x5832), 0x12345678);
  EXPECT_EQ(unit.read(0x5833), unit.parameter(2, 2)) << "a number without unit";
}

TEST(FreeObjects, ShowTheInputAtTheirPlaceWhileTheyAreMapped) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_TRUE(unit.set_parameter(2, 8746, 0, 1.0));
  ASSERT_EQ(unit.write(0x1A04, 1, 0x58100010), 0U);
  ASSERT_EQ(unit.write(0x1A04, 2, 0x58300020), 0U);
  EXPECT_EQ(unit.read(0x5810), 0) << "p8851[6] is not connected";

  ASSERT_EQ(unit.write(0x5800, 0, 0x0777), 0U);
  ASSERT_TRUE(unit.set_parameter(2, 8851, 6, drive::own_source(8745, 0)));
  ASSERT_TRUE(unit.set_parameter(2, 8861, 7, 1.0));
  EXPECT_EQ(unit.read(0x5810), 0x0777);
  EXPECT_EQ(unit.read(0x5830), 0x40000000);
  EXPECT_EQ(unit.parameter(2, 8853, 6), 0x0777);
  EXPECT_EQ(unit.parameter(2, 8863, 7), 0x40000000);
}

TEST(FreeObjects, TravelInPdos) {
  Configuration configuration =
      unit_with({{8851, drive::own_source(8850, 4), 6}, {8861, drive::own_source(62, 0), 7}});
  TestUnit unit{configuration};
  unit.start();
  unit.expect_dialogue({
      {"605#2304160110000058", "585#6004160100000000"},  // 5800h
      {"605#2304140112030000", "585#6004140100000000"},
      {"605#23041A0110001058", "585#60041A0100000000"},  // 5810h
      {"605#23041A0220003058", "585#60041A0200000000"},  // 5830h
      {"605#2304180192010000", "585#6004180100000000"},
  });
  EXPECT_EQ(from("192#", unit.says("000#0105")), Lines{"192#000000000000"});

  EXPECT_EQ(from("192#", unit.cycles_with("312#FE4A")), Lines{"192#FE4A00000000"});
}

}  // namespace
}  // namespace device
