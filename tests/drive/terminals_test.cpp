// Digital inputs and outputs of the control unit (r0721 to r0723, p0728, p0738 to r0747, p0748, p0795, p0796).
#include "drive/control_unit/terminals.hpp"

#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr std::uint32_t kEveryTerminal = 0x0033FFFF;  // DI 0 to 7, DI/DO 8 to 15, DI 16, 17, 20, 21

struct WiredTerminals : WiredUnit {
  void apply(unsigned number, bool high) { unit.control_unit().terminals().apply(number, high); }
  std::uint32_t word(std::uint16_t number) const { return static_cast<std::uint32_t>(read(kUnit, number)); }
  State state() { return axis(kX).actual().state; }
};

TEST(Terminals, AreThoseOfTheControlUnit) {
  for (unsigned number = 0; number < 64; ++number)
    EXPECT_EQ(Terminals::exists(number), number < 32 && (kEveryTerminal >> number & 1U) != 0) << number;
}

TEST(Terminals, ShowWhatIsAppliedAndItsInverse) {
  WiredTerminals wired;
  EXPECT_EQ(wired.word(722), 0U);
  EXPECT_EQ(wired.word(723), kEveryTerminal);
  for (const unsigned number : {0U, 9U, 21U}) wired.apply(number, true);
  wired.apply(9, false);
  EXPECT_EQ(wired.word(721), 0x00200001U);
  EXPECT_EQ(wired.word(722), 0x00200001U);
  EXPECT_EQ(wired.word(723), kEveryTerminal & ~0x00200001U);
}

TEST(Terminals, AreReadAsZeroWhileTheyAreOutputs) {
  WiredTerminals wired;
  wired.apply(8, true);
  wired.apply(15, true);
  ASSERT_EQ(wired.write(kUnit, 728, 0x0100), std::nullopt);
  EXPECT_EQ(wired.word(721), 0x8000U);
  EXPECT_EQ(wired.word(722), 0x8000U);
  ASSERT_EQ(wired.write(kUnit, 728, 0x000300FF), std::nullopt);
  EXPECT_EQ(wired.word(728), 0U) << "only DI/DO 8 to 15 can be outputs";
  EXPECT_EQ(wired.word(722), 0x8100U);
}

TEST(Terminals, ShowWhatP0795SimulatesInTheirPlace) {
  WiredTerminals wired;
  wired.apply(1, true);
  ASSERT_EQ(wired.write(kUnit, 795, 0x000C0006), std::nullopt);
  ASSERT_EQ(wired.write(kUnit, 796, 0x000C0014), std::nullopt);
  EXPECT_EQ(wired.word(795), 0x0006U) << "there are no terminals 18 and 19";
  EXPECT_EQ(wired.word(721), 0x0002U);
  EXPECT_EQ(wired.word(722), 0x0004U);
}

TEST(Terminals, PutOutWhatTheyAreConnectedTo) {
  WiredTerminals wired;
  wired.wire(kUnit, 738, {722, kOwnObject, 3});
  wired.wire(kUnit, 745, {899, kX, 0});  // ready to switch on
  wired.set(kUnit, 741, true);
  ASSERT_EQ(wired.write(kUnit, 748, 0x1000), std::nullopt);
  wired.cycles();
  EXPECT_EQ(wired.word(747), 0x1800U);
  wired.apply(3, true);
  wired.command(kX, 0x0006);
  EXPECT_EQ(wired.word(747), 0x9900U);
  wired.set(kUnit, 738, false);
  wired.cycles();
  EXPECT_EQ(wired.word(747), 0x9800U);
}

TEST(Terminals, SwitchAnAxisOnAndOff) {
  WiredTerminals wired;
  for (const std::uint16_t input : std::initializer_list<std::uint16_t>{844, 848, 852}) wired.set(kX, input, true);
  wired.wire(kX, 840, {722, kUnit, 1});
  wired.cycles(2);
  ASSERT_EQ(wired.state(), State::ReadyToSwitchOn);
  wired.apply(1, true);
  wired.cycles(2);
  EXPECT_EQ(wired.state(), State::OperationEnabled);
  wired.apply(1, false);
  wired.cycles(100);
  EXPECT_EQ(wired.state(), State::ReadyToSwitchOn);
}

TEST(Terminals, AcknowledgeAtTheirEdge) {
  WiredTerminals wired;
  wired.wire(kX, 2104, {722, kUnit, 2});
  wired.wire(kY, 2103, {723, kUnit, 2});
  wired.cycles(2);
  for (const std::uint8_t object : {kX, kY}) ASSERT_TRUE(wired.unit.raise(object, 7860));
  wired.cycles(2);
  wired.apply(2, true);
  wired.cycles(2);
  EXPECT_TRUE(wired.axis(kX).messages().faults().empty());
  EXPECT_FALSE(wired.axis(kY).messages().faults().empty());
  wired.apply(2, false);
  wired.cycles(2);
  EXPECT_TRUE(wired.axis(kY).messages().faults().empty());
}

TEST(Terminals, CanBeTheSourceOfEveryBinectorInput) {
  WiredTerminals wired;
  int inputs = 0;
  for (const std::uint8_t object : {kUnit, kX})
    for (const PlacedRow& placed : parameters_of(wired.unit.object(object)->kind())) {
      if (placed.row->type != DataType::BinectorInput) continue;
      for (const std::uint16_t source : std::initializer_list<std::uint16_t>{721, 722, 723, 747})
        EXPECT_EQ(wired.write(object, placed.row->number, pack({source, kUnit, 8})), std::nullopt)
            << "p" << placed.row->number;
      ++inputs;
    }
  EXPECT_GT(inputs, 60);
}

}  // namespace
}  // namespace drive
