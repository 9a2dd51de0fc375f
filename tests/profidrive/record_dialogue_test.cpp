/// Records as manuals print them, and what follows from the rules of the base mode parameter access.
#include "tests/profidrive/record_unit.hpp"

namespace profidrive {
namespace {

/// A dialogue with a new unit.
struct Dialogue {
  const char* name;
  std::vector<device::Exchange> exchanges;
  std::size_t axes = 1;
};

class RecordDialogue : public testing::TestWithParam<Dialogue> {};

TEST_P(RecordDialogue, GoesAsWritten) {
  RecordUnit unit{std::vector<device::AxisSetup>(GetParam().axes)};

  for (const auto& [request, answer] : GetParam().exchanges) EXPECT_EQ(unit.record(request), answer) << request;
}

INSTANTIATE_TEST_SUITE_P(Printed, RecordDialogue,
                         testing::Values(Dialogue{"JogWiring",
                                                  {{"400202041001041F000010010420000010010422000010010423000007"
                                                    "0102D20404070102D20405080143960000080144160000",
                                                    "40020204"},
                                                   {"41010204 1001041F0000 100104200000 100104220000 100104230000",
                                                    "41010204070102D20404070102D20405080143960000080144160000"}}},
                                         Dialogue{"FixedValues",
                                                  {{"01020301 10000B540000 0801 41A00000", "01020301"},
                                                   {"0101030210000B54000010040B560002",
                                                    "01010302080141A0000008044120000041A000004248000042C80000"}},
                                                  2},
                                         Dialogue{"FindingTheDriveObjects",
                                                  {{"0C010101100100660000", "0C01010106010003"},
                                                   {"0D010101100300650000", "0D0101010603000100020003"},
                                                   {"0E0102011000006B0000", "0E0102010301000B"}},
                                                  2}),
                         [](const auto& test) { return std::string{test.param.name}; });

INSTANTIATE_TEST_SUITE_P(
    ByTheRules, RecordDialogue,
    testing::Values(
        Dialogue{"NoSuchParameter", {{"010102011001EA5F0000", "0181020144010000"}}},
        Dialogue{"WriteOfAReadOnlyOne", {{"0202020110010015000008013F800000", "02820201440200010000"}}},
        Dialogue{
            "PartialWrite",
            {{"030202031001042200001001046000001001042300000801439600000801BF8000000801C3960000",
              "0382020340004402000200004000"},
             {"04010203100104220000100104600000100104230000", "040102030801439600000801412000000801C3960000"}}},
        Dialogue{"NoSuchDriveObject", {{"05010902100103B10000100103B30000", "0581090144010019"}}},
        Dialogue{"WrongType", {{"060202011001042200000601012C", "0682020144010005"}}},
        Dialogue{
            "DoubleWordForAFloat",
            {{"070202011001042200004301437A0000", "07020201"}, {"08010201100104220000", "080102010801437A0000"}}},
        Dialogue{"ByteIsPadded", {{"09010201100100320000", "0901020105010000"}}},
        Dialogue{"NeedsCommissioning", {{"0A020201100101300000080143C80000", "0A8202014401006E"}}},
        Dialogue{"IndexBeyondTheEnd", {{"0B010201100803B1003C", "0B810201440200030040"}}},
        Dialogue{"CountDoesNotMatch",
                 {{"0602020110020422000008013F800000", "0682020144010004"},
                  {"0702020110010422000008023F80000040000000", "0782020144010018"}}},
        Dialogue{"DeclaredButMissing", {{"0A010202100103B10000", "0A81020144010016"}}},
        Dialogue{"TextAndBadAttribute", {{"0B010202300107D00000500107D00000", "0B8102024401000F44010016"}}},
        Dialogue{"BytesBehindAreIgnored", {{"09010201100100320000 FFFFFF", "0901020105010000"}}},
        Dialogue{"ReferenceZero", {{"00010201100100320000", "0001020105010000"}}},
        Dialogue{"ValuesBeforeARefusedOneStay",
                 {{"01020201 100407A60000 0804 3F800000 40000000 C0A00000 40400000", "01820201440200020002"},
                  {"02010201 100407A60000", "0201020108043F80000040000000BF800000BF800000"}}}),
    [](const auto& test) { return std::string{test.param.name}; });

TEST(Record, ShowsTheFaultOfADriveObject) {
  RecordUnit unit;
  ASSERT_TRUE(unit.device.raise(1, 7900, 0, unit.now));

  EXPECT_EQ(unit.record("25010201100803B10000"), "2501020106081EDC0000000000000000000000000000");
}

}  // namespace
}  // namespace profidrive
