// BICO inputs: order of a cycle, converters, axes that rest, and what is refused.
#include "drive/wiring.hpp"

#include <vector>

#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr double kWord = 0x4000;

TEST(Wiring, TakesTheStateOfTheInterfaceBitByBit) {
  WiredUnit wired;
  wired.wire(kX, 1020, {8843, kOwnObject, 0});
  wired.wire(kX, 1021, {8843, kOwnObject, 2});
  wired.unit.object(kX)->process_data().interface_state = {false, false, true};
  wired.cycles();
  EXPECT_FALSE(inputs_of(wired.axis(kX)).fixed_setpoint_bit_0);
  EXPECT_TRUE(inputs_of(wired.axis(kX)).fixed_setpoint_bit_1);
  EXPECT_EQ(wired.write(kX, 1022, pack({8843, kOwnObject, 3})), Refusal::IllegalSource);
}

TEST(Wiring, RefusesWhatIsNoSource) {
  const std::uint32_t fine = pack({8890, kOwnObject, 0});
  struct Case {
    std::uint16_t input;
    BicoSource source;
    const char* why;
  };
  const std::vector<Case> cases{
      {840, {8850, kOwnObject, 0}, "a connector has no bits"},
      {840, {1024, kOwnObject, 0}, "neither has a speed"},
      {840, {8890, kOwnObject, 16}, "a word has 16 bits"},
      {840, {8890, 4, 0}, "there is no third axis"},
      {840, {8890, 0, 0}, "there is no drive object 0"},
      {840, {8889, kOwnObject, 1023}, "no such bit"},
      {840, {3, kOwnObject, 0}, "no parameter"},
      {840, {840, kOwnObject, 0}, "an input is no source"},
      {840, {0, kOwnObject, 2}, "no constant"},
      {840, {722, kOwnObject, 0}, "the digital inputs are on the control unit"},
      {1070, {8860, kOwnObject, 19}, "the last double word begins at word 18"},
      {1070, {8850, kOwnObject, 20}, "20 words are received"},
      {1070, {1120, kOwnObject, 0}, "a time is no connector"},
      {1070, {1070, kOwnObject, 0}, "an input is no source"},
      {1070, {8860, 62, 0}, "no such drive object"},
      {1070, {9999, kY, 0}, "no parameter"},
      {1070, {1024, kUnit, 0}, "the control unit has no fixed setpoints"},
  };
  for (const Case& c : cases) {
    WiredUnit wired;
    ASSERT_EQ(wired.write(kX, 840, fine), std::nullopt);
    const double before = wired.read(kX, c.input);
    EXPECT_EQ(wired.write(kX, c.input, pack(c.source)), Refusal::IllegalSource) << c.why;
    EXPECT_EQ(wired.read(kX, c.input), before) << c.why;
  }
  WiredUnit wired;
  EXPECT_EQ(wired.write(kX, 840, 2.0), Refusal::IllegalSource) << "0 and 1 are the constants";
  EXPECT_EQ(wired.write(kX, 8851, 1.0, 25), Refusal::NoIndex);
  EXPECT_EQ(wired.write(kUnit, 2102, pack({722, kOwnObject, 3})), std::nullopt);
}

TEST(Wiring, ChangesInOperation) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 1120, 0.0), std::nullopt);
  wired.receives_double_word(kX, 1, 0x10000000);  // p1070 of a new axis
  wired.switch_on(kX);
  wired.cycles(200);
  ASSERT_NEAR(wired.rpm(kX), 0.25 * wired.read(kX, 2000), 1.0);

  wired.receives_double_word(kY, 3, 0x08000000);
  wired.wire(kX, 1070, {8860, kY, 3});
  wired.cycles();
  EXPECT_NEAR(inputs_of(wired.axis(kX)).main_setpoint, 0.125 * wired.read(kX, 2000) * kRpm, 1e-3);
  ASSERT_EQ(wired.write(kX, 1121, 0.0), std::nullopt);
  wired.cycles(250);
  EXPECT_NEAR(wired.rpm(kX), 0.125 * wired.read(kX, 2000), 1.0);

  wired.set(kX, 844, false);
  wired.cycles();
  EXPECT_EQ(wired.state(kX), State::SwitchOnDisabled) << "OFF2";
}

TEST(Wiring, LetsOneAxisFollowAnother) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 1120, 0.5), std::nullopt);
  ASSERT_EQ(wired.write(kY, 1120, 0.0), std::nullopt);
  wired.wire(kY, 840, {899, kX, 2});    // ON while X operates
  wired.wire(kY, 1070, {1170, kX, 0});  // X's setpoint behind its ramp
  wired.set(kY, 844, true);
  wired.set(kY, 848, true);
  wired.set(kY, 852, true);
  wired.receives_double_word(kX, 1, 0x10000000);
  wired.cycles(2);
  ASSERT_EQ(wired.state(kY), State::ReadyToSwitchOn);

  wired.switch_on(kX);
  wired.cycles(500);
  EXPECT_EQ(wired.state(kY), State::OperationEnabled);
  EXPECT_NEAR(wired.rpm(kY), wired.rpm(kX), 0.5);
  EXPECT_NEAR(wired.rpm(kY), 0.25 * wired.read(kX, 2000), 1.0);
}

TEST(Wiring, HasWhatLiesOnAnAxisOfTheLastCycleAndWhatTheBusBroughtOfThisOne) {
  WiredUnit wired;
  wired.wire(kY, 1070, {1024, kX, 0});
  wired.wire(kX, 1020, {8891, kOwnObject, 0});
  ASSERT_EQ(wired.write(kX, 1001, 100.0), std::nullopt);
  const double share = 100.0 / wired.read(kX, 2000) * wired.read(kY, 2000) * kRpm;

  wired.receives(kX, 1, 1);
  wired.cycles();
  EXPECT_NEAR(wired.read(kX, 1024), 100.0, 1e-3) << "chosen in the cycle, in whatever state";
  EXPECT_EQ(inputs_of(wired.axis(kY)).main_setpoint, 0.0);
  wired.cycles();
  EXPECT_NEAR(inputs_of(wired.axis(kY)).main_setpoint, share, 1e-3);
}

TEST(Wiring, ConvertsWordsToBitsBeforeTheInputsOfTheSameCycle) {
  WiredUnit wired;
  wired.wire(kX, 8899, {8850, kOwnObject, 7});
  wired.wire(kX, 8899, {8850, kUnit, 0}, 1);
  ASSERT_EQ(wired.write(kX, 8898, 0x0001, 1), std::nullopt);
  wired.wire(kX, 840, {8894, kOwnObject, 3});
  wired.wire(kY, 1113, {8895, kX, 0});

  wired.receives(kX, 7, 0x0008);
  wired.cycles();
  EXPECT_EQ(wired.read(kX, 8894), 0x0008);
  EXPECT_EQ(wired.read(kX, 8895), 0x0001);
  EXPECT_TRUE(inputs_of(wired.axis(kX)).on);
  EXPECT_TRUE(inputs_of(wired.axis(kY)).invert_setpoint) << "inverted";
  wired.receives(kUnit, 0, 0x0001);
  wired.receives(kX, 7, 0xFFF7);
  wired.cycles();
  EXPECT_FALSE(inputs_of(wired.axis(kX)).on);
  EXPECT_FALSE(inputs_of(wired.axis(kY)).invert_setpoint);
}

TEST(Wiring, SendsInTheSameCycleTheWordsThatAreMadeOfBits) {
  WiredUnit wired;
  for (std::uint16_t converter = 0; converter < 5; ++converter) {
    const auto input = static_cast<std::uint16_t>(8880 + converter);
    wired.wire(kX, input, {899, kOwnObject, 2}, converter);  // operation enabled
    wired.wire(kX, input, {899, kY, 2}, 15);
    wired.wire(kX, 8851, {8889, kOwnObject, converter}, 10U + converter);
    ASSERT_EQ(wired.write(kX, 8888, 0x0100, converter), std::nullopt);
  }
  wired.cycles();
  EXPECT_EQ(wired.read(kX, 8853, 12), 0x0100) << "inverted";

  wired.command(kX, 0x0006);
  wired.command(kX, 0x0007);
  wired.receives(kX, 0, 0x000F);
  wired.cycles();
  ASSERT_EQ(wired.state(kX), State::OperationEnabled);
  for (std::size_t converter = 0; converter < 5; ++converter)
    EXPECT_EQ(wired.read(kX, 8853, 10 + converter), 0x0100U + (1U << converter)) << "in the cycle itself";
  wired.switch_on(kY);
  EXPECT_EQ(wired.read(kX, 8853, 10), 0x8101);
}

TEST(Wiring, BringsBitsOfTheStatusword) {
  for (const auto& [input, bit] : {std::pair{8785, 8}, std::pair{8786, 14}, std::pair{8787, 15}}) {
    WiredUnit wired;
    const auto number = static_cast<std::uint16_t>(input);
    wired.cycles(2);
    EXPECT_EQ(wired.axis(kX).actual().statusword >> bit & 1, 0);
    wired.wire(kX, number, {8890, kY, 5});
    wired.receives(kY, 0, 0x0020);
    wired.cycles();
    EXPECT_EQ(wired.axis(kX).actual().statusword >> bit & 1, 1) << "p" << input;
    wired.set(kX, number, false);
    wired.cycles();
    EXPECT_EQ(wired.axis(kX).actual().statusword >> bit & 1, 0) << "p" << input;
  }
}

TEST(Wiring, AcknowledgesOnEveryEdgeOfEveryInput) {
  for (const auto& [object, input] :
       {std::pair{kX, 2103}, std::pair{kX, 2104}, std::pair{kX, 2105}, std::pair{kUnit, 2102}}) {
    WiredUnit wired;
    wired.wire(object, static_cast<std::uint16_t>(input), {8892, kY, 9});
    wired.cycles(2);
    ASSERT_TRUE(wired.axis(kX).raise(7860));
    wired.cycles(2);
    ASSERT_EQ(wired.state(kX), State::Fault);
    wired.receives(kY, 2, 0x0200);
    wired.cycles(2);
    EXPECT_NE(wired.state(kX), State::Fault) << "p" << input;
    ASSERT_TRUE(wired.axis(kX).raise(7860));
    wired.cycles(2);
    EXPECT_EQ(wired.state(kX), State::Fault) << "the level does not acknowledge: p" << input;
  }
}

TEST(Wiring, BringsMessagesToTheControlUnit) {
  for (const auto& [input, number] :
       {std::pair{2106, 7860}, std::pair{2107, 7861}, std::pair{2108, 7862}, std::pair{2112, 7850}}) {
    WiredUnit wired;
    const FaultMemory& messages = wired.unit.object(kUnit)->messages();
    const auto active = [&, message = number] { return message == 7850 ? messages.alarms() : messages.faults(); };
    wired.cycles();
    ASSERT_TRUE(active().empty());

    wired.set(kUnit, static_cast<std::uint16_t>(input), false);
    wired.cycles();
    ASSERT_EQ(active().size(), 1U) << "p" << input;
    EXPECT_EQ(active().front().row->number, number);
    EXPECT_EQ(wired.unit.acknowledge(kUnit), number == 7850) << "its cause is still there";

    wired.set(kUnit, static_cast<std::uint16_t>(input), true);
    wired.cycles();
    EXPECT_TRUE(wired.unit.acknowledge(kUnit));
    EXPECT_TRUE(active().empty());
  }
}

TEST(Wiring, WakesAnAxisThatRestsWhenItsSourceChanges) {
  WiredUnit wired;
  wired.wire(kY, 840, {8890, kX, 11});
  wired.set(kY, 844, true);
  wired.set(kY, 848, true);
  wired.cycles(10);
  ASSERT_TRUE(wired.axis(kY).is_quiescent());
  ASSERT_EQ(wired.state(kY), State::ReadyToSwitchOn);

  wired.awake = {true, false};
  wired.receives(kX, 0, 0x0800);
  wired.cycles();
  EXPECT_EQ(wired.state(kY), State::SwitchedOn);
  wired.set(kY, 852, true);
  wired.cycles();
  EXPECT_EQ(wired.state(kY), State::OperationEnabled);
}

TEST(Wiring, LetsAnAxisThatWasWokenGoOn) {
  WiredUnit wired;
  wired.set(kY, 844, true);
  wired.set(kY, 848, true);
  wired.set(kY, 852, true);
  ASSERT_EQ(wired.write(kY, 1120, 0.0), std::nullopt);
  wired.wire(kY, 840, {8890, kX, 11});
  wired.wire(kY, 1070, {8860, kX, 5});
  wired.cycles(10);
  ASSERT_TRUE(wired.axis(kY).is_quiescent());

  wired.awake = {true, false};
  wired.receives(kX, 0, 0x0800);
  wired.receives_double_word(kX, 5, 0x10000000);
  wired.cycles(250);
  EXPECT_NEAR(wired.rpm(kY), 0.25 * wired.read(kY, 2000), 1.0);
}

TEST(Wiring, ShowsTheStatusBitsOfAnAxisThatRests) {
  WiredUnit wired;
  wired.wire(kY, 8786, {8890, kX, 11});
  wired.cycles(10);
  ASSERT_TRUE(wired.axis(kY).is_quiescent());

  wired.awake = {true, false};
  wired.receives(kX, 0, 0x0800);
  wired.cycles();
  EXPECT_NE(wired.axis(kY).actual().statusword & 0x4000, 0);
}

TEST(Wiring, TakesTheSetpointOfTheMessagesFromAnySource) {
  WiredUnit wired;
  wired.receives_double_word(kX, 1, 0x08000000);
  ASSERT_EQ(wired.write(kX, 1120, 0.0), std::nullopt);
  wired.switch_on(kX);
  wired.cycles(250);
  EXPECT_NE(wired.axis(kX).actual().statusword & 0x0400, 0) << "target reached";

  wired.wire(kX, 2151, {8860, kY, 0});
  wired.receives_double_word(kY, 0, 0x20000000);
  wired.cycles(100);
  EXPECT_EQ(wired.axis(kX).actual().statusword & 0x0400, 0);
}

TEST(Wiring, GivesNothingToAnInputThatIsUnwired) {
  WiredUnit wired;
  wired.set(kX, 8851, false);
  wired.cycles(2);
  EXPECT_EQ(wired.read(kX, 8853, 0), 0.0);
  wired.set(kX, 8851, true);
  wired.cycles();
  EXPECT_EQ(wired.read(kX, 8853, 0), kWord);
}

}  // namespace
}  // namespace drive
