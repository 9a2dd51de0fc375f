#include <gtest/gtest.h>

#include "drive/parameter/bico.hpp"
#include "tests/device/process_data_unit.hpp"

namespace device {
namespace {

constexpr std::int64_t kInvalid = 0x80000000;
constexpr std::int64_t kThreeThousandRpm = 0x0C800000;  // increments/s

TEST(ProcessDataBuffers, ShowWhatIsReceivedRelativeToTheReferences) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_TRUE(unit.set_parameter(2, 2000, 0, 3000.0));
  ASSERT_TRUE(unit.set_parameter(2, 2003, 0, unit.parameter(2, 333)));
  ASSERT_EQ(unit.write(0x6040, 0, 0x047F), 0U);

  ASSERT_EQ(unit.write(0x60FF, 0, kThreeThousandRpm), 0U);
  ASSERT_EQ(unit.write(0x6071, 0, 500), 0U);
  EXPECT_EQ(unit.parameter(2, 8850, 0), 0x047F);
  EXPECT_EQ(unit.parameter(2, 8890), 0x047F);
  EXPECT_EQ(unit.parameter(2, 8860, 1), 0x40000000);
  EXPECT_EQ(unit.parameter(2, 8850, 1), 0x4000) << "its upper word";
  EXPECT_EQ(unit.parameter(2, 8891), 0x4000);
  EXPECT_EQ(unit.parameter(2, 8850, 2), 0);
  EXPECT_EQ(unit.parameter(2, 8850, 3), 0x2000);
  EXPECT_EQ(unit.parameter(2, 8893), 0x2000);
  EXPECT_EQ(unit.parameter(2, 8850, 4), 0) << "nothing is there";

  ASSERT_EQ(unit.write(0x60FF, 0, -kThreeThousandRpm / 2), 0U);
  ASSERT_EQ(unit.write(0x6071, 0, -500), 0U);
  EXPECT_EQ(unit.parameter(2, 8860, 1), -0x20000000);
  EXPECT_EQ(unit.parameter(2, 8850, 3), -0x2000);
}

TEST(ProcessDataBuffers, SaturateAtTwiceTheReferences) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_TRUE(unit.set_parameter(2, 2000, 0, 1000.0));

  for (const int sign : {1, -1}) {
    ASSERT_EQ(unit.write(0x60FF, 0, sign * kThreeThousandRpm), 0U);
    ASSERT_EQ(unit.write(0x6071, 0, sign * 32767), 0U);
    EXPECT_EQ(unit.parameter(2, 8860, 1), sign > 0 ? 2147483647.0 : -2147483648.0);
    EXPECT_EQ(unit.parameter(2, 8850, 3), sign > 0 ? 32767.0 : -32768.0);
  }
}

TEST(ProcessDataBuffers, ShowWhatIsSent) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_TRUE(unit.set_parameter(2, 1083, 0, 1500.0));
  ASSERT_TRUE(unit.set_parameter(2, 2000, 0, 3000.0));
  ASSERT_TRUE(unit.set_parameter(2, 8861, 1, drive::own_source(1083, 0)));
  ASSERT_TRUE(unit.set_parameter(2, 8851, 3, 1.0));

  EXPECT_EQ(unit.parameter(2, 8853, 0), unit.parameter(2, 8784)) << "p8851[0] is wired to the statusword";
  EXPECT_EQ(unit.parameter(2, 8863, 1), 0x20000000);
  EXPECT_EQ(unit.parameter(2, 8853, 1), 0x2000);
  EXPECT_EQ(unit.read(0x606C), kThreeThousandRpm / 2);
  EXPECT_EQ(unit.parameter(2, 8853, 3), 0x4000);
  EXPECT_EQ(unit.read(0x6077), 1000);
}

TEST(ProcessDataBuffers, SendNothingFromAPlaceThatIsNotConnected) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_TRUE(unit.set_parameter(2, 8851, 0, 1.0));
  ASSERT_EQ(unit.read(0x6041), 0x4000);

  ASSERT_TRUE(unit.set_parameter(2, 8851, 0, 0.0));
  EXPECT_EQ(unit.read(0x6041), 0);
}

TEST(ProcessDataBuffers, FollowAMappingOnceItIsWritten) {
  ProcessDataUnit unit{2};
  unit.start();
  EXPECT_EQ(unit.parameter(3, 8750, 4), 0);

  ASSERT_EQ(unit.write(0x1644, 1, 0x58800010), 0U);
  EXPECT_EQ(unit.parameter(3, 8750, 4), 0x5880);
  ASSERT_EQ(unit.write(0x1645, 1, 0x68600008), 0U);
  EXPECT_EQ(unit.parameter(3, 8750, 5), 0x6860);
  ASSERT_EQ(unit.write(0x5880, 0, -2), 0U);
  ASSERT_EQ(unit.write(0x6860, 0, -20), 0U);
  EXPECT_EQ(unit.parameter(3, 8850, 4), -2);
  EXPECT_EQ(unit.parameter(3, 8850, 5), -20) << "one byte on the bus, a word with its sign here";
  EXPECT_EQ(unit.parameter(3, 8745, 0), 0) << "for an object without a place only";

  ASSERT_EQ(unit.write(0x1644, 1, 0), 0U);
  EXPECT_EQ(unit.parameter(3, 8750, 4), 0x6860) << "what follows moves up";
  EXPECT_EQ(unit.parameter(3, 8745, 0), -2);
}

TEST(ProcessDataBuffers, AreEmptyOnTheControlUnit) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_EQ(unit.write(0x6040, 0, 0x047F), 0U);

  EXPECT_EQ(unit.parameter(1, 8850, 0), 0);
  EXPECT_EQ(unit.parameter(1, 8890), 0);
}

TEST(ProcessDataBuffers, TellTheStateOfTheInterface) {
  ProcessDataUnit unit{1};
  unit.start();
  EXPECT_EQ(unit.parameter(2, 8843, 0), 1);
  EXPECT_EQ(unit.parameter(2, 8843, 2), 0);

  unit.command(canopen::NmtCommand::Start);
  EXPECT_EQ(unit.parameter(2, 8843, 0), 0);
  EXPECT_EQ(unit.parameter(2, 8843, 2), 1);
}

TEST(ProcessDataBuffers, TellTheHighestWordThatIsConnected) {
  ProcessDataUnit unit{2};
  unit.start();
  EXPECT_EQ(unit.parameter(2, 8867, 1), 6) << "p8861[4] sends r0482";

  ASSERT_TRUE(unit.set_parameter(2, 1070, 0, drive::own_source(8860, 10)));
  EXPECT_EQ(unit.parameter(2, 8867, 0), 12);
  ASSERT_TRUE(unit.set_parameter(3, 8746, 0, drive::pack({8850, 2, 19})));
  EXPECT_EQ(unit.parameter(2, 8867, 0), 20) << "another drive object takes it";
  ASSERT_TRUE(unit.set_parameter(2, 8851, 24, 1.0));
  EXPECT_EQ(unit.parameter(2, 8867, 1), 25);
}

TEST(Converters, MakeWordsOfBits) {
  ProcessDataUnit unit{2};
  unit.start();
  ASSERT_EQ(unit.write(0x6040, 0, 0x0081), 0U);  // of axis 1
  ASSERT_TRUE(unit.set_parameter(3, 8880, 0, 1.0));
  ASSERT_TRUE(unit.set_parameter(3, 8880, 3, drive::pack({8890, 2, 7})));
  ASSERT_TRUE(unit.set_parameter(3, 8880, 15, drive::pack({8890, 2, 6})));
  EXPECT_EQ(unit.parameter(3, 8889, 0), 0x0009);

  ASSERT_TRUE(unit.set_parameter(3, 8888, 0, 0x8001));
  EXPECT_EQ(unit.parameter(3, 8889, 0), 0x8008);
  EXPECT_EQ(unit.parameter(3, 8889, 4), 0x0000);
}

TEST(Converters, GiveTheBitsOfWords) {
  ProcessDataUnit unit{1};
  unit.start();
  ASSERT_EQ(unit.write(0x6040, 0, 0xC081), 0U);
  ASSERT_TRUE(unit.set_parameter(1, 8899, 1, drive::pack({8890, 2, 0})));
  EXPECT_EQ(unit.parameter(1, 8895), 0xC081);
  ASSERT_TRUE(unit.set_parameter(1, 8898, 1, 0x00FF));
  EXPECT_EQ(unit.parameter(1, 8895), 0xC07E);
  ASSERT_TRUE(unit.set_parameter(1, 8899, 0, drive::own_source(8894, 0)));
  ASSERT_TRUE(unit.set_parameter(1, 8898, 0, 0x0001));
  const double before = unit.parameter(1, 8894);
  EXPECT_NE(unit.parameter(1, 8894), before) << "a converter behind itself has its word of the last cycle";
}

TEST(ControlwordWiring, NeedsTheControlwordInTheFirstFourWords) {
  ProcessDataUnit unit{1};
  unit.start();
  EXPECT_TRUE(unit.set_parameter(2, 8790, 0, 1.0));

  for (std::uint16_t place = 0; place < 4; ++place) {
    ASSERT_EQ(unit.write(static_cast<std::uint16_t>(0x1400 + place), 1, kInvalid), 0U);
    ASSERT_EQ(unit.write(static_cast<std::uint16_t>(0x1600 + place), 0, 0), 0U);
  }
  EXPECT_FALSE(unit.set_parameter(2, 8790, 0, 1.0));
  EXPECT_TRUE(unit.set_parameter(2, 8790, 0, 0.0));
}

}  // namespace
}  // namespace device
