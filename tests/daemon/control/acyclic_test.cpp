// Records (DS47) and parameter channels (PKW) over the control socket.
#include <gtest/gtest.h>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

struct Acyclic : ControlledUnit {
  std::string record(const std::string& request) {
    return result_of("parameter.record", {{"request", request}}).at("response");
  }
  std::string exchange(int object, const std::string& request) {
    return result_of("pkw.exchange", {{"do", object}, {"request", request}}).at("response");
  }
  std::string refusal(const char* method, const json& params) {
    const control::Error error = error_of(method, params);
    EXPECT_EQ(error.code, ErrorCode::BadParameter);
    return error.message;
  }
};

TEST_F(Acyclic, AnswersARecordInHexadecimal) {
  EXPECT_EQ(record("0E0102011000006B0000"), "0E0102010301000B");
  EXPECT_EQ(record("0e 01 02 01 10 00 00 6b 0000"), "0E0102010301000B");
}

TEST_F(Acyclic, CarriesOutWhatARecordWrites) {
  EXPECT_EQ(record("07020201100104600000080140000000"), "07020201");

  const json read = result_of("parameter.read", {{"parameters", {"1/p1120"}}});
  EXPECT_EQ(read.at("parameters").at(0).at("value"), 2.0);
}

TEST_F(Acyclic, BeginsASaveThatGoesOnBehindTheAnswer) {
  EXPECT_EQ(record("01020101100103D10000 0601 0001"), "01020101");
  await_write();

  EXPECT_EQ(record("01010101100103D10000"), "0101010106010000");
}

TEST_F(Acyclic, KeepsAChannelForEachDriveObject) {
  switch_on(unit_of(2));

  EXPECT_EQ(exchange(2, "3460 0000 4000 0000"), "2460000040000000");
  EXPECT_EQ(record("07020201100104600000080140400000"), "07020201");
  EXPECT_EQ(exchange(3, "3460 0000 4000 0000"), "2460000040000000");
  EXPECT_EQ(exchange(2, "3460 0000 4000 0000"), "2460000040000000");
  EXPECT_EQ(record("01010201100104600000"), "01010201080140400000");
  EXPECT_EQ(exchange(1, "1066 0000 0000 0000"), "1066000000000003") << "r0102 of the control unit";
}

TEST_F(Acyclic, SaysWhatIsWrongWithTheDigits) {
  EXPECT_EQ(refusal("parameter.record", {{"request", ""}}),
            "request: expected 1 to 240 bytes of two hexadecimal digits each, got \"\"");
  EXPECT_EQ(refusal("parameter.record", {{"request", "0"}}),
            "request: expected 1 to 240 bytes of two hexadecimal digits each, got \"0\"");
  EXPECT_EQ(refusal("parameter.record", {{"request", "0g"}}),
            "request: expected 1 to 240 bytes of two hexadecimal digits each, got \"0g\"");
  EXPECT_EQ(refusal("parameter.record", {{"request", std::string(482, '0')}}).substr(0, 70),
            "request: expected 1 to 240 bytes of two hexadecimal digits each, got \"");
  EXPECT_EQ(refusal("pkw.exchange", {{"do", 2}, {"request", "10000000"}}),
            "request: expected 8 bytes of two hexadecimal digits each, got \"10000000\"");
  EXPECT_EQ(refusal("pkw.exchange", {{"do", 2}}),
            "request: expected 8 bytes of two hexadecimal digits each, got nothing");
}

TEST_F(Acyclic, SaysWhichDriveObjectThereIsNone) {
  EXPECT_EQ(refusal("pkw.exchange", {{"do", 9}, {"request", "1000008000000000"}}),
            "do: the unit has no drive object 9");
  EXPECT_EQ(record("05010902100103B10000100103B30000"), "0581090144010019");
}

TEST_F(Acyclic, TakesTheLongestRecord) {
  EXPECT_EQ(record("01" + std::string(478, '0')), "0180000144010021");
}

}  // namespace
}  // namespace axisd
