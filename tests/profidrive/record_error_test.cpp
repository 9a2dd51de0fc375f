/// Every error that the unit raises, from its cause.
#include "tests/profidrive/record_unit.hpp"

namespace profidrive {
namespace {

/// What is asked of a new unit with two axes, and the error that answers, behind the header.
struct Cause {
  const char* name;
  const char* request;
  const char* error;
};

class RecordError : public testing::TestWithParam<Cause> {};

TEST_P(RecordError, ComesFromItsCause) {
  RecordUnit unit{std::vector<device::AxisSetup>(2)};

  const std::string answer = unit.record(GetParam().request);

  ASSERT_GT(answer.size(), 8U);
  EXPECT_EQ(answer.substr(8), GetParam().error);
  EXPECT_GE(answer[2], '8') << answer;
}

INSTANTIATE_TEST_SUITE_P(
    OfAParameter, RecordError,
    testing::Values(Cause{"NoParameter_00", "01010201 1001 EA5F 0000", "44010000"},
                    Cause{"NoParameterOfANumberOfTheControlUnit_00", "01010201 1001 0009 0000", "44010000"},
                    Cause{"ReadOnly_01", "01020201 1001 0015 0000 0801 3F800000", "440200010000"},
                    Cause{"ReadOnlyNamesItsIndex_01", "01020201 1001 03B1 0005 0601 0000", "440200010005"},
                    Cause{"BelowTheList_02", "01020201 1001 0460 0000 0801 BF800000", "440200020000"},
                    Cause{"AboveTheList_02", "01020201 1001 0460 0000 0801 501502F9", "440200020000"},
                    Cause{"NotANumber_02", "01020201 1001 0460 0000 0801 7FC00000", "440200020000"},
                    Cause{"NoIndex_03", "01010201 1001 03B1 0040", "440200030040"},
                    Cause{"NoIndexFarBeyond_03", "01010201 10FF 03B1 FFFF", "44020003FFFF"},
                    Cause{"NoArray_04", "01010201 1001 0460 0001", "44010004"},
                    Cause{"NoArrayOfElements_04", "01010201 1002 0460 0000", "44010004"},
                    Cause{"WrongSize_05", "01020201 1001 0460 0000 4201 0001", "44010005"},
                    Cause{"WrongType_05", "01020201 1001 0460 0000 0701 00000001", "44010005"},
                    Cause{"NoValues_05", "01020201 1001 0460 0000 4001", "44010005"},
                    Cause{"Errors_05", "01020201 1001 0460 0000 4401 0000", "44010005"},
                    Cause{"TypeBeforeAccess_05", "01020201 1001 0015 0000 0601 0000", "44010005"},
                    Cause{"OnlyZero_06", "01020201 1001 03B8 0000 0601 0001", "440200060000"},
                    Cause{"DescriptionIsFixed_07", "01020201 2001 0460 0003 0801 3F800000", "440200070003"},
                    Cause{"NoDescription_09", "01010201 2001 0460 000D", "44010009"},
                    Cause{"DescriptionOfNothing_00", "01010201 2001 EA5F 000D", "44010000"},
                    Cause{"NoText_0F", "01010201 3001 07D0 0000", "4401000F"},
                    Cause{"NoTextToWrite_0F", "01020201 3001 07D0 0000 4101 2000", "4401000F"},
                    Cause{"IllegalValue_14", "01020201 1001 000A 0000 0301 004D", "440200140000"},
                    Cause{"UnknownAttribute_16", "01010201 5001 07D0 0000", "44010016"},
                    Cause{"UnknownFormat_17", "01020201 1001 0460 0000 0901 3F800000", "44010017"},
                    Cause{"CountDiffers_18", "01020201 1001 0460 0000 0800", "44010018"},
                    Cause{"OnlyWithP0010_3_6E", "01020201 1001 0130 0000 0801 43C80000", "4401006E"},
                    Cause{"OnlyWithP0010_30_72", "01020201 1001 03CA 0000 0601 0001", "44010072"},
                    Cause{"OnlyWithP0009_7F", "01020101 1001 0065 0001 0601 0002", "4401007F"},
                    Cause{"OnlyWithP0009_30_7D", "01020101 1001 03D0 0000 0601 0001", "4401007D"},
                    Cause{"IllegalSource_83", "01020201 1001 0348 0000 0701 FFFFFFFF", "44010083"},
                    Cause{"AddressSwitch_65", "01020101 1001 21AC 0000 0501 0600", "44010065"}),
    [](const auto& test) { return std::string{test.param.name}; });

INSTANTIATE_TEST_SUITE_P(OfTheRequest, RecordError,
                         testing::Values(Cause{"UnknownService_21", "01030201 1001 0460 0000", "44010021"},
                                         Cause{"UnknownServiceBeforeAll_21", "0177", "44010021"},
                                         Cause{"NoDriveObject_19", "01010901 1001 0460 0000", "44010019"},
                                         Cause{"DriveObjectZero_19", "01010001 1001 0460 0000", "44010019"},
                                         Cause{"DriveObjectBeforeCount_19", "01010900", "44010019"},
                                         Cause{"NoParameters_16", "01010200", "44010016"},
                                         Cause{"TooManyParameters_16", "01010228", "44010016"},
                                         Cause{"OnlyAReference_16", "01", "44010016"},
                                         Cause{"OnlyAService_16", "0101", "44010016"},
                                         Cause{"NoCount_16", "010102", "44010016"},
                                         Cause{"ShortAddress_16", "01010201 1001 0460 00", "44010016"},
                                         Cause{"NoValue_16", "01020201 1001 0460 0000", "44010016"},
                                         Cause{"HalfAValue_16", "01020201 1001 0460 0000 0801 3F80", "44010016"},
                                         Cause{"NoFillByte_16", "01020201 1001 0F8D 0000 0501 01", "44010016"}),
                         [](const auto& test) { return std::string{test.param.name}; });

/// p0010 = @p filter of the axis.
void commission(RecordUnit& unit, const std::string& filter) {
  ASSERT_EQ(unit.record("010202011001000A00000301" + filter), "01020201");
}

TEST(RecordErrors, NameTheCommissioningThatIsMissing) {
  RecordUnit unit;

  EXPECT_EQ(unit.record("01020201 1001 0190 0000 0301 0001"), "018202014401006D");  // p0400
  commission(unit, "0004");
  EXPECT_EQ(unit.record("01020201 1001 0190 0000 0301 07D2"), "01020201");
  EXPECT_EQ(unit.record("01020201 1001 0064 0000 0301 0000"), "0182020144010070");  // p0100
}

TEST(RecordErrors, ComeFromThePulses) {
  RecordUnit unit;
  unit.enable();

  EXPECT_EQ(unit.record("01020201 1001 21C1 0000 0301 0001"), "018202014401006B");  // p8641
}

TEST(RecordErrors, ComeWhileParametersAreSaved) {
  RecordUnit unit;
  unit.listener.is_slow = true;

  EXPECT_EQ(unit.record("01020101 1001 03D1 0000 0601 0001"), "01020101");  // p0977
  EXPECT_EQ(unit.record("02020201 1001 0460 0000 0801 40000000"), "0282020144010011");
  EXPECT_EQ(unit.record("03010201 1001 0460 0000"),
            "030102010801"
            "41200000");
  unit.device.on_stored(true, unit.now);
  EXPECT_EQ(unit.record("04020201 1001 0460 0000 0801 40000000"), "04020201");
}

/// p1532 has no list of its own to be compared with what other parameters allow.
TEST(RecordErrors, TellLimitsOfOtherParametersFromThoseOfTheList) {
  RecordUnit unit;

  // p8720[3] of the list: any U32; as reserved sub-index no more than FFh.
  EXPECT_EQ(unit.record("01020201 1001 2210 0003 0701 00000100"), "01820201440100C9");
}

TEST(RecordErrors, ComeFromTheAuthorityThatP0927Gives) {
  RecordUnit unit;
  const char* const write = "01020201 1001 0460 0000 0801 40000000";

  EXPECT_EQ(unit.record("01020201 1001 039F 0000 0601 FFFE"), "01020201");
  EXPECT_EQ(unit.record(write), "018202014401000B");
  EXPECT_EQ(unit.record("03010201 1001 0460 0000"), "03010201080141200000");
  EXPECT_EQ(unit.record("01020101 1001 0B54 0000 0801 40000000"), "01020101");  // p2900 of the control unit
  EXPECT_EQ(unit.exchange("3460 0000 4000 0000"), "2460000040000000");
  EXPECT_EQ(unit.record("01020201 1001 039F 0000 0601 0001"), "01020201");
  EXPECT_EQ(unit.record(write), "01020201");
  EXPECT_EQ(unit.exchange("3460 0000 4040 0000"), "74600000000B0000");
}

TEST(RecordErrors, TellWhatDoesNotFitIntoTheAnswer) {
  RecordUnit unit;

  // 59 times four bytes do not leave room for what comes; a short one behind does.
  EXPECT_EQ(unit.record("01010202 1077 0001 0000 1001 0032 0000"),
            "0181020244010000"
            "05010000");
  const std::string answer = unit.record("01010203 1040 03B5 0000 1001 0032 0000 1001 0032 0000");
  EXPECT_EQ(answer,
            "0181020344010015"
            "05010000"
            "05010000");  // r0949: 4 + 258
  const std::string fits = unit.record("01010202 1039 03B5 0000 1001 0032 0000");
  EXPECT_EQ(fits.size(), 2 * (4 + 2 + 57 * 4 + 4U));
  EXPECT_EQ(fits.substr(0, 12), "010102020439");
}

}  // namespace
}  // namespace profidrive
