#include "profidrive/telegram/telegrams.hpp"
#include "tests/profidrive/if1_unit.hpp"

namespace profidrive {
namespace {

using enum drive::RefusalReason;

TEST(Telegram, IsOfferedByKindAndFunctionModule) {
  const auto offered = [](const unit::Configuration& configuration, std::uint8_t object) {
    std::vector<unsigned> numbers;
    If1Unit unit{configuration};
    for (unsigned number = object == If1Unit::kControlUnit ? 390 : 1; number < 999; ++number)
      if (unit.write(922, number, 0, object)) numbers.push_back(number);
    return numbers;
  };
  using Numbers = std::vector<unsigned>;
  EXPECT_EQ(offered(If1Unit::servo(), If1Unit::kAxis),
            (Numbers{1, 2, 3, 4, 5, 6, 102, 103, 105, 106, 116, 350, 353, 354}));
  EXPECT_EQ(offered(If1Unit::vector(), If1Unit::kAxis), (Numbers{1, 2, 3, 4, 20, 350, 352, 353, 354}));
  EXPECT_EQ(offered(If1Unit::positioner(), If1Unit::kAxis), (Numbers{7, 9, 110, 111, 350, 353, 354}));
  EXPECT_EQ(offered(If1Unit::servo(), If1Unit::kControlUnit), (Numbers{390, 391, 394}));
}

TEST(Telegram, ThatIsNotOfferedIsNoValue) {
  If1Unit unit;
  for (const double number : {8.0, 20.0, 118.0, 111.0, 352.0, 390.0})
    EXPECT_EQ(unit.refusal(922, number), IllegalValue);
  EXPECT_EQ(unit.refusal(2079, 8.0), IllegalValue);
  EXPECT_EQ(unit.refusal(922, 392.0, 0, If1Unit::kControlUnit), IllegalValue);
  EXPECT_EQ(unit.refusal(922, 0.0), BelowMinimum);
  EXPECT_EQ(unit.read(922), 999.0);
}

TEST(Telegram, WiresTheInputsOfItsWords) {
  If1Unit unit;
  unit.set(840, drive::pack({722, If1Unit::kControlUnit, 1}));

  unit.set(922, 1.0);

  EXPECT_EQ(unit.read(840), own(2090, 0));
  EXPECT_EQ(unit.read(854), own(2090, 10));
  EXPECT_EQ(unit.read(1140), own(2090, 4));
  EXPECT_EQ(unit.read(2103), own(2090, 7));
  EXPECT_EQ(unit.read(1070), own(2050, 1));
  EXPECT_EQ(unit.read(2051, 0), own(2089, 0));
  EXPECT_EQ(unit.read(2051, 1), own(63, 0));
  EXPECT_EQ(unit.read(2080, 2), own(899, 2));
  EXPECT_EQ(unit.read(2088, 0), 0xA800);
  EXPECT_EQ(unit.read(2079), 1.0);
  EXPECT_EQ(unit.read(2038), 0.0);
  EXPECT_EQ(unit.read(8790), 0.0);
  EXPECT_EQ(unit.read(922, 0, If1Unit::kSecondAxis), 999.0);
  EXPECT_EQ(unit.read(840, 0, If1Unit::kSecondAxis), own(8890, 0));
}

TEST(Telegram, LeadsTheSpeedSetpointBehindTheRampWithoutSetpointChannel) {
  If1Unit unit{If1Unit::servo_without_channel()};
  unit.set(922, 2.0);
  EXPECT_EQ(unit.read(1155), own(2060, 1));
  EXPECT_EQ(unit.read(2061, 1), own(63, 0));
  EXPECT_EQ(unit.read(2051, 1), 0.0);
  EXPECT_EQ(unit.read(2045), own(2050, 3));
}

TEST(Telegram, LocksWhatItHasWired) {
  If1Unit unit;
  unit.set(922, 1.0);
  for (const int number : {840, 844, 848, 852, 854, 1070, 1140, 1141, 1142, 1113, 2103, 2038, 8790})
    EXPECT_EQ(unit.refusal(static_cast<std::uint16_t>(number), 0.0), Locked) << "p" << number;
  EXPECT_EQ(unit.refusal(2051, 0.0, 0), Locked);
  EXPECT_EQ(unit.refusal(2051, own(68), 5), Locked);
  EXPECT_EQ(unit.refusal(2080, 0.0, 3), Locked);
  EXPECT_EQ(unit.refusal(2079, 2.0), Locked);
  EXPECT_EQ(unit.refusal(8790, 1.0), Locked);
  unit.set(2081, own(899, 0), 3);
  unit.set(1055, drive::pack({722, If1Unit::kControlUnit, 2}));
}

TEST(Telegram, LeavesItsWiringBehindAndFree) {
  If1Unit unit;
  unit.set(922, 2.0);
  unit.set(922, 999.0);
  EXPECT_EQ(unit.read(840), own(2090, 0));
  EXPECT_EQ(unit.read(2079), 999.0);
  unit.set(840, own(8890, 0));
  unit.set(2051, own(68), 0);
  EXPECT_EQ(unit.read(840), own(8890, 0));
}

TEST(Telegram, CanBeExtendedByWordsBehindIt) {
  If1Unit unit;
  unit.set(2079, 1.0);
  EXPECT_EQ(unit.read(922), 999.0);
  EXPECT_EQ(unit.refusal(840, 0.0), Locked);
  EXPECT_EQ(unit.refusal(2051, 0.0, 1), Locked);
  unit.set(2051, own(68, 1), 2);
  unit.set(2061, own(63), 3);
  EXPECT_EQ(unit.if1.words_to_send(If1Unit::kAxis), 5U);
}

TEST(Telegram, ProposesAndLeavesFreeWords) {
  If1Unit unit{If1Unit::vector()};
  unit.set(922, 20.0);
  EXPECT_EQ(unit.read(2038), 2.0);
  EXPECT_EQ(unit.read(2051, 4), own(82, 1));
  unit.set(2051, own(68), 5);
  EXPECT_EQ(unit.read(2051, 5), own(68));
  EXPECT_EQ(unit.refusal(2051, own(68), 4), Locked);
  unit.set(922, 352.0);
  unit.set(1503, own(2050, 3));
}

TEST(Telegram, SetsTheInterfaceModeAndWhatItsStatusWordsInvert) {
  If1Unit unit;
  unit.set(922, 102.0);
  EXPECT_EQ(unit.read(2038), 1.0);
  EXPECT_EQ(unit.read(2088, 0), 0.0);
  EXPECT_EQ(unit.read(2088, 2), 0x00C0);
  EXPECT_EQ(unit.read(2080, 14), own(1407, 2));
  unit.set(922, 1.0);
  EXPECT_EQ(unit.read(2088, 0), 0xA800);
}

TEST(Telegram, IsSavedAndWiredAgain) {
  If1Unit unit;
  unit.set(922, 3.0);
  unit.set(977, 1.0, 0, If1Unit::kControlUnit);
  ASSERT_FALSE(unit.shelf.image.empty());

  If1Unit again;
  ASSERT_TRUE(again.runner.load_parameters(unit.shelf.image));
  EXPECT_EQ(again.read(922), 3.0);
  EXPECT_EQ(again.read(2079), 3.0);
  EXPECT_EQ(again.read(840), own(2090, 0));
  EXPECT_EQ(again.refusal(840, 0.0), Locked);
}

TEST(Telegram, OfThePresetsIsWired) {
  unit::Configuration configuration = If1Unit::vector();
  configuration.axis_presets = {{{922, 20.0}}, {}};
  If1Unit unit{configuration};
  EXPECT_EQ(unit.read(922), 20.0);
  EXPECT_EQ(unit.read(840), own(2090, 0));
  EXPECT_EQ(unit.read(2051, 1), own(63, 1));
  EXPECT_EQ(unit.refusal(840, 0.0), Locked);
}

TEST(Telegram, EndsWithAFactoryReset) {
  If1Unit unit;
  unit.set(922, 3.0);
  unit.set(9, 30.0, 0, If1Unit::kControlUnit);
  unit.set(976, 1.0, 0, If1Unit::kControlUnit);
  unit.passes(50ms);
  EXPECT_EQ(unit.read(922), 999.0);
  EXPECT_EQ(unit.read(840), own(8890, 0));
  unit.set(840, 0.0);
}

TEST(Telegram, OfPositioningWiresItsWords) {
  If1Unit unit{If1Unit::positioner()};
  unit.set(922, 111.0);
  EXPECT_EQ(unit.read(2646), own(2050, 4));
  EXPECT_EQ(unit.read(2642), own(2060, 5));
  EXPECT_EQ(unit.read(2647), own(2091, 15));
  EXPECT_EQ(unit.read(2655), own(2092, 0));
  EXPECT_EQ(unit.read(2061, 5), own(2521, 0));
  EXPECT_EQ(unit.read(2099, 0), own(2669, 0));
  EXPECT_EQ(unit.refusal(2099, 0.0), Locked);
  EXPECT_EQ(unit.read(2088, 0), 0.0);
  unit.set(922, 9.0);
  EXPECT_EQ(unit.read(2099, 0), own(2050, 9));
  EXPECT_EQ(unit.read(2648), own(2094, 0));
}

TEST(Telegram, OfTheControlUnitHasItsTerminals) {
  If1Unit unit;
  unit.set(922, 390.0, 0, If1Unit::kControlUnit);
  EXPECT_EQ(unit.read(738, 0, If1Unit::kControlUnit), own(2091, 0));
  EXPECT_EQ(unit.refusal(738, 0.0, 0, If1Unit::kControlUnit), Locked);
  EXPECT_EQ(unit.read(2051, 1, If1Unit::kControlUnit), own(2089, 1));
  EXPECT_EQ(unit.read(2081, 8, If1Unit::kControlUnit), own(722, 0));
  unit.runner.set_input(3, true, unit.runner.now());
  const Words sent = unit.exchange({0x0400, 0}, 20ms, If1Unit::kControlUnit);
  EXPECT_EQ(sent[1], 0x0800);
}

}  // namespace
}  // namespace profidrive
