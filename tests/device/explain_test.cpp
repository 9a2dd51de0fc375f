// What the node and its process data have to do with an axis that does not turn.
#include <gtest/gtest.h>

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

std::string told(const TestUnit& unit, std::size_t axis = 1) {
  std::string lines;
  for (const std::string& sentence : unit.device.explain(axis)) lines += sentence + "\n";
  return lines;
}

bool tells(const TestUnit& unit, std::string_view sentence, std::size_t axis = 1) {
  return told(unit, axis).find(sentence) != std::string::npos;
}

constexpr std::string_view kNothingReceived =
    "The controlword is 0000h, as if none had been received yet: send 0006h, then 000Fh.\n";

TEST(ExplainUnit, NamesTheNmtStateFirst) {
  TestUnit unit;
  unit.start();
  unit.passes(100ms);

  EXPECT_EQ(told(unit).find("The node is Pre-operational, so that no PDO is received: send the NMT command start "
                            "(01h).\n"),
            0U)
      << told(unit);
  EXPECT_TRUE(tells(unit, "OFF2 is given by p0844 = r8890.1"));
  unit.says("000#0105");
  unit.passes(10ms);
  EXPECT_EQ(told(unit).find(kNothingReceived), 0U) << told(unit);
  unit.says("000#0205");
  EXPECT_TRUE(tells(unit, "The node is Stopped"));
}

TEST(ExplainUnit, IsContentWithAnAxisThatTurns) {
  TestUnit unit;
  unit.turn_at(600.0, 2s);

  const std::vector<std::string> sentences = unit.device.explain(1);

  ASSERT_EQ(sentences.size(), 1U);
  EXPECT_EQ(sentences.front().rfind("It turns at ", 0), 0U) << sentences.front();
  EXPECT_TRUE(tells(unit, "(setpoint 600 rpm)"));
}

TEST(ExplainUnit, MissesAValidRpdoOfAFurtherAxis) {
  Configuration configuration = unit_with({});
  configuration.axes.push_back({});
  TestUnit unit{configuration};
  unit.start_operational();
  unit.passes(10ms);

  EXPECT_FALSE(tells(unit, "The RPDO of the controlword", 1));
  EXPECT_TRUE(
      tells(unit, "The RPDO of the controlword 6840h is not valid: write its COB-ID with bit 31 = 0.\n", 2))
      << told(unit, 2);
}

TEST(ExplainUnit, MissesTheMappingOfTheControlword) {
  TestUnit unit;
  unit.start();
  // Every RPDO without the controlword: COB-IDs invalid, entries away.
  for (std::uint16_t rpdo = 0; rpdo < 4; ++rpdo) {
    const auto identifier = 0x80000000U | (0x205U + 0x100U * rpdo);
    unit.download(static_cast<std::uint16_t>(0x1400 + rpdo), 1, identifier, 4);
    unit.download(static_cast<std::uint16_t>(0x1600 + rpdo), 0, 0, 1);
    unit.download(static_cast<std::uint16_t>(0x1600 + rpdo), 1, 0, 4);
  }
  unit.passes(10ms);

  EXPECT_TRUE(tells(unit, "No RPDO maps the controlword 6040h: map it, or write it over SDO.\n")) << told(unit);
}

TEST(ExplainUnit, TellsAFaultBeforeAnRpdoThatIsNotValid) {
  Configuration configuration = unit_with({});
  configuration.axes.push_back({});
  TestUnit unit{configuration};
  unit.start_operational();
  unit.passes(10ms);
  ASSERT_TRUE(unit.device.raise(2, 7860, 0, unit.now));
  unit.passes(10ms);

  EXPECT_EQ(told(unit, 2).find("Fault F07860"), 0U) << told(unit, 2);
  EXPECT_TRUE(tells(unit, "The RPDO of the controlword 6840h is not valid", 2)) << told(unit, 2);
}

TEST(ExplainUnit, DoesNotTellAnAxisOfRpdosThatIsCommandedOverSdo) {
  Configuration configuration = unit_with({});
  configuration.axes.push_back({});
  TestUnit unit{configuration};
  unit.start();
  for (const std::uint32_t word : {0x0006U, 0x0007U}) {
    unit.download(0x6840, 0, word, 2);
    unit.passes(10ms);
  }

  EXPECT_FALSE(tells(unit, "RPDO", 2)) << told(unit, 2);
  EXPECT_FALSE(tells(unit, "PDO", 2)) << told(unit, 2);
  EXPECT_EQ(told(unit, 2).find("The operation enable is missing (p0852 = r8890.3)"), 0U) << told(unit, 2);

  ASSERT_TRUE(unit.device.raise(2, 7860, 0, unit.now));
  unit.passes(10ms);
  EXPECT_EQ(told(unit, 2).find("Fault F07860"), 0U) << told(unit, 2);
  EXPECT_FALSE(tells(unit, "RPDO", 2)) << told(unit, 2);
}

TEST(ExplainUnit, MissesTheConnectionOfOn) {
  TestUnit unit{unit_with({{.number = 840, .value = 0}})};
  unit.start_operational();
  unit.cycles_with("205#0600");

  EXPECT_TRUE(tells(unit,
                    "ON (p0840) is not connected to bit 0 of the controlword: write p8790 = 1, or command its "
                    "source.\n"))
      << told(unit);
  EXPECT_TRUE(tells(unit, "ON is missing (p0840 = 0): write p0840 = 1 or connect it"));
}

}  // namespace
}  // namespace device
