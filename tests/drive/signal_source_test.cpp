#include "drive/signal_source.hpp"

#include <gtest/gtest.h>

namespace drive {
namespace {

constexpr double kWord = 0x4000;

struct TwoAxes {
  DriveUnit unit{{.axes = {{}, {}}, .node_id = 5}};

  double value(const BicoSource& source, double full = kWord) const {
    return SignalSource{unit, unit.axes()[0], pack(source)}.value(full);
  }
  bool bit(std::uint32_t packed) const { return SignalSource{unit, unit.axes()[0], packed}.bit(); }
  double parameter(std::uint8_t object, std::uint16_t number) const {
    return unit.object(object)->read(number).value();
  }
};

TEST(SignalSources, BringQuantitiesRelativeToTheReferenceOfTheirDriveObject) {
  TwoAxes two;
  ASSERT_TRUE(two.unit.axes()[0].write(2000, 1000.0));
  ASSERT_TRUE(two.unit.axes()[1].write(2000, 500.0));
  const double speed = two.parameter(2, 1083);

  EXPECT_DOUBLE_EQ(two.value({1083, kOwnObject, 0}), speed / 1000.0 * kWord);
  EXPECT_DOUBLE_EQ(two.value({1083, 2, 0}), speed / 1000.0 * kWord);
  EXPECT_DOUBLE_EQ(two.value({1083, 3, 0}), two.parameter(3, 1083) / 500.0 * kWord);
  EXPECT_DOUBLE_EQ(two.value({1083, 3, 0}, 0x40000000), two.parameter(3, 1083) / 500.0 * 0x40000000);
}

TEST(SignalSources, BringEveryUnitThatHasAReference) {
  TwoAxes two;
  struct Case {
    std::uint16_t source, reference;
  };
  for (const auto& [source, reference] : {Case{1083, 2000}, Case{26, 2001}, Case{27, 2002}, Case{1520, 2003},
                                          Case{32, 2004}, Case{35, 2006}, Case{1149, 2007}})
    EXPECT_DOUBLE_EQ(two.value({source, 2, 0}), two.parameter(2, source) / two.parameter(2, reference) * kWord)
        << source;
  EXPECT_DOUBLE_EQ(two.value({2692, 2, 0}), two.parameter(2, 2692) / 100.0 * kWord) << "percent";
}

TEST(SignalSources, BringNumbersWithoutUnitAsTheyAre) {
  TwoAxes two;

  EXPECT_EQ(two.value({2, 2, 0}), two.parameter(2, 2));
  EXPECT_EQ(two.value({2691, 2, 0}), two.parameter(2, 2691)) << "1000 LU/min have no reference";
}

TEST(SignalSources, KnowTheConstants) {
  TwoAxes two;

  EXPECT_EQ((SignalSource{two.unit, two.unit.axes()[0], 0}.value(kWord)), 0.0);
  EXPECT_EQ((SignalSource{two.unit, two.unit.axes()[0], 1}.value(kWord)), kWord);
  EXPECT_FALSE(two.bit(0));
  EXPECT_TRUE(two.bit(1));
}

TEST(SignalSources, BringNothingFromWhatIsNotThere) {
  TwoAxes two;

  EXPECT_EQ(two.value({1083, 9, 0}), 0.0);
  EXPECT_EQ(two.value({1, 2, 0}), 0.0);
  EXPECT_FALSE(two.bit(pack({898, 9, 0})));
}

TEST(SignalSources, BringSingleBits) {
  TwoAxes two;
  two.unit.axes()[1].process_data().received[0] = 0x0005;

  for (std::uint16_t bit = 0; bit < 16; ++bit)
    EXPECT_EQ(two.bit(pack({8890, 3, bit})), bit == 0 || bit == 2) << bit;
}

}  // namespace
}  // namespace drive
