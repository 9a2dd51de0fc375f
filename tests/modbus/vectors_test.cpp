// Examples byte for byte that need no axis in motion and no records.
#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/modbus/hexadecimal.hpp"
#include "tests/modbus/served_unit.hpp"

namespace modbus {
namespace {

struct Step {
  std::string_view request, response;
};

struct Vector {
  std::string_view name;
  std::vector<Step> steps;

  friend void PrintTo(const Vector& vector, std::ostream* stream) { *stream << vector.name; }
};

const std::array kVectors{
    Vector{"write-one-word", {{"000100000006110600635566", "000100000006110600635566"}}},
    Vector{"ds47-not-ready",
           {{"0001000000151110025800070E00012F0A80010101100100020000", "000100000006111002580007"},
            {"000100000006110302580007", "00010000001111030E00012F0000040000000000000000"}}},
    Vector{"too-many-registers", {{"00010000000611030063007E", "000100000003118303"}}},
    Vector{"beyond-the-end",
           {{"000100000006110302D10001", "0001000000051103020000"},
            {"000100000006110302D10002", "000100000003118302"},
            {"000100000006110302D20001", "000100000003118302"}}},
    Vector{"write-read-only",
           {{"0001000000061106006D0001", "000100000003118604"},
            {"000100000006110301F20001", "0001000000051103020001"}}},
    Vector{"reserved-reads-zero",
           {{"000100000006110300C70003", "000100000009110306000000000000"},
            {"000100000006110300000001", "0001000000051103020000"}}},
    Vector{"unknown-function",
           {{"000100000006110400630001", "000100000003118401"},
            {"000100000005112B0E0100", "00010000000311AB01"},
            {"000100000006110300C70001", "0001000000051103020000"}}},
    Vector{"drive-identification",
           {{"0001000000061103012C0001", "00010000000511030201E0"},
            {"000100000006110301430001", "0001000000051103020BB8"}}},
    Vector{"write-ramp",
           {{"0001000000061106014105DC", "0001000000061106014105DC"},
            {"000100000006110301410002", "00010000000711030405DC03E8"}}},
    Vector{"write-below-minimum",
           {{"000100000006110601430005", "000100000003118604"},
            {"000100000006110301F20001", "0001000000051103020002"},
            {"000100000006110301430001", "0001000000051103020BB8"}}},
    Vector{"write-across-a-border",
           {{"00010000000B1110006C00020400010002", "000100000003119004"},
            {"0001000000061103006C0001", "0001000000051103020000"}}},
    Vector{"ds47-wrong-function-code",
           {{"0001000000151110025800070E0001300A80010201100100020000", "000100000006111002580007"},
            {"000100000006110302580003", "00010000000911030600022F000003"}}},
};

TEST(RecordVectors, ReadAParameterOfTheUnitAndOfTheAxis) {
  ServedUnit unit;
  EXPECT_EQ(unit.exchange("0001000000151110025800070E00012F0A80010101100100020000"), "000100000006111002580007");
  unit.passes(std::chrono::milliseconds{100});
  const std::string of_unit = unit.exchange("000100000006110302580007");
  EXPECT_EQ(of_unit.substr(0, 38), "00010000001111030E00022F08800101010301");
  EXPECT_EQ(of_unit.substr(42), "0000");

  EXPECT_EQ(unit.exchange("0001000000151110025800070E00012F0A80010201100100020000"), "000100000006111002580007");
  unit.passes(std::chrono::milliseconds{100});
  EXPECT_EQ(
      unit.exchange("000100000006110302580007"),
      fmt::format("00010000001111030E00022F08800102010301{:04X}0000", static_cast<unsigned>(unit.value(2, 2))));
}

/// A source of p2051: word @p index of r2050 of the own drive object.
constexpr double received_word(unsigned index) {
  constexpr unsigned kReceived = 2050, kOwn = 63;
  return static_cast<double>(kReceived << 16U | kOwn << 10U | index);
}

TEST(ProcessDataVectors, ReadTwoWords) {
  ServedUnit unit;
  unit.set(2, 2051, received_word(1), 0);
  unit.set(2, 2051, received_word(2), 1);
  EXPECT_EQ(unit.exchange("00010000000D1110006300030604001122"
                          "3344"),
            "000100000006111000630003");
  unit.passes(std::chrono::milliseconds{20});
  EXPECT_EQ(unit.exchange("0001000000061103006D0002"), "00010000000711030411223344");
  EXPECT_EQ(unit.exchange("000100000006110300630003"), "000100000009110306040011223344");
}

TEST(ProcessDataVectors, Timeout) {
  ServedUnit unit;
  unit.set(2, 922, 1);
  unit.set(1, 2040, 500);
  unit.set(2, 2044, 0);
  unit.passes(std::chrono::seconds{2});
  EXPECT_EQ(unit.exchange("0001000000061103018F0001"), "0001000000051103020000")
      << "never written: time does not run";
  EXPECT_EQ(unit.exchange("00010000000611060063047E"), "00010000000611060063047E");
  unit.passes(std::chrono::milliseconds{400});
  EXPECT_EQ(unit.exchange("0001000000061103006D0001").size(), 22U) << "begins the time anew";
  unit.passes(std::chrono::milliseconds{400});
  EXPECT_EQ(unit.exchange("0001000000061103018F0001"), "0001000000051103020000");
  unit.passes(std::chrono::milliseconds{400});
  EXPECT_EQ(unit.exchange("0001000000061103018F0001"), "0001000000051103020776");
}

class Vectors : public testing::TestWithParam<Vector> {};

TEST_P(Vectors, AreAnsweredStepByStep) {
  ServedUnit unit;
  for (const Step& step : GetParam().steps) EXPECT_EQ(unit.exchange(step.request), step.response);
}

TEST_P(Vectors, AreAnsweredInOneSegment) {
  ServedUnit unit;
  std::string requests, responses;
  for (const Step& step : GetParam().steps) {
    requests += step.request;
    responses += step.response;
  }
  EXPECT_EQ(unit.exchange(requests), responses);
}

TEST_P(Vectors, AreAnsweredByteByByte) {
  ServedUnit unit;
  for (const Step& step : GetParam().steps) {
    std::string response;
    for (std::size_t i = 0; i < step.request.size(); i += 2) response += unit.exchange(step.request.substr(i, 2));
    EXPECT_EQ(response, step.response);
  }
}

INSTANTIATE_TEST_SUITE_P(ModbusTcp, Vectors, testing::ValuesIn(kVectors));

}  // namespace
}  // namespace modbus
