#include <array>
#include <bit>
#include <map>

#include "tests/device/test_unit.hpp"
#include "tests/eds/rules/objects_csv.hpp"

namespace device {
namespace {

constexpr std::uint32_t kReadOnly = 0x06010002, kNoObject = 0x06020000, kWrongLength = 0x06070010;
constexpr std::uint32_t kNoSubIndex = 0x06090011, kInvalidValue = 0x06090030, kTooHigh = 0x06090031;
constexpr std::uint32_t kTooLow = 0x06090032, kDeviceState = 0x08000022;
constexpr std::uint16_t kWindow = 0x41B6;

constexpr std::uint16_t object_of(std::uint16_t number) {
  return static_cast<std::uint16_t>(0x2000 + number);
}

double real(const Upload& upload) {
  EXPECT_EQ(upload.bytes.size(), 4U);
  return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(upload.number())));
}

std::uint32_t bits(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

/// A unit of three axes whose window shows what a test chooses.
struct WindowUnit : TestUnit {
  WindowUnit() : TestUnit{{.node_id = 5, .axes = std::vector<AxisSetup>(3)}} { start(); }

  void open(std::uint16_t object, std::uint16_t indices = 0, std::uint16_t numbers = 0) {
    const std::array values{object, indices, numbers};
    for (std::uint8_t i = 0; i < values.size(); ++i) ASSERT_EQ(download(kWindow, i, values[i], 2), 0U);
  }
};

TEST(ParameterWindow, IsClosedFromTheFactory) {
  WindowUnit unit;

  for (std::uint8_t i = 0; i < 3; ++i) EXPECT_EQ(unit.upload(kWindow, i).number(), 0U);
  EXPECT_EQ(unit.upload(kWindow, 3).abort_code, kNoSubIndex);
  for (unsigned index = 0x2000; index <= 0x470F; ++index) {
    if (index == kWindow) continue;
    const auto object = static_cast<std::uint16_t>(index);
    ASSERT_EQ(unit.upload(object).abort_code, kNoObject) << std::hex << index;
    ASSERT_EQ(unit.download(object, 0, 0, 4), kNoObject) << std::hex << index;
  }
}

/// The last sub-index of each object of @p scope as the EDS files of the real unit have it.
std::map<std::uint16_t, unsigned> last_sub_indices(const std::string& scope) {
  std::map<std::uint16_t, unsigned> last;
  for (const eds_test::Fact& fact : eds_test::read_facts())
    if (fact.at("scope") == scope && !eds_test::is_head(fact))
      last[eds_test::index_of(fact)] = eds_test::sub_index_of(fact);
  return last;
}

TEST(ParameterWindow, HasTheSubIndicesOfTheEdsAndNoOther) {
  TestUnit unit{{.node_id = 5, .axes = {{}, {.drive = {.kind = drive::ObjectKind::Vector}}}}};
  unit.start();
  std::size_t objects = 0;
  std::uint16_t drive_object = 0;
  for (const char* const scope : {"cu-parameter", "servo-parameter", "vector-parameter"}) {
    ASSERT_EQ(unit.download(kWindow, 0, ++drive_object, 2), 0U);
    for (const auto& [index, last] : last_sub_indices(scope)) {
      ++objects;
      for (unsigned sub_index = 0; sub_index <= 0xFF; ++sub_index)
        EXPECT_EQ(unit.upload(index, static_cast<std::uint8_t>(sub_index)).abort_code,
                  sub_index <= last ? 0U : kNoSubIndex)
            << scope << ' ' << std::hex << index << ':' << sub_index;
    }
  }
  EXPECT_EQ(objects, 64U);
}

TEST(ParameterWindow, ShowsTheDriveObjectThatItIsOpenedFor) {
  WindowUnit unit;

  unit.open(1);
  EXPECT_EQ(unit.upload(object_of(2)).number(), 0U);  // r0002 of the control unit: ready
  EXPECT_EQ(unit.upload(object_of(8684)).number(), 127U);
  EXPECT_EQ(unit.upload(object_of(1120)).abort_code, kNoObject);

  for (const std::uint16_t axis : std::vector<std::uint16_t>{2, 3, 4}) {
    unit.open(axis);
    EXPECT_EQ(unit.upload(object_of(2)).number(), 43U);
    EXPECT_EQ(unit.upload(object_of(8684)).abort_code, kNoObject);
    EXPECT_EQ(unit.download(object_of(1120), 0, bits(axis), 4), 0U);
  }
  for (std::size_t axis = 1; axis <= 3; ++axis)
    EXPECT_EQ(unit.device.axis(axis).read(1120).value(), static_cast<double>(axis + 1));
}

TEST(ParameterWindow, HasNoObjectOfADriveObjectThatDoesNotExist) {
  WindowUnit unit;

  for (const std::uint16_t object : std::vector<std::uint16_t>{0, 5, 255, 256, 258, 0xFFFF}) {
    unit.open(object);
    EXPECT_EQ(unit.upload(object_of(2)).abort_code, kNoObject) << object;
    EXPECT_EQ(unit.upload(kWindow).number(), object);
  }
}

TEST(ParameterWindow, ReachesIndicesBeyond255) {
  WindowUnit unit;
  unit.open(2, 1);

  EXPECT_EQ(unit.upload(object_of(947), 0).abort_code, kNoSubIndex);
  EXPECT_EQ(unit.upload(kWindow, 1).number(), 1U);
  unit.open(2, 0);
  EXPECT_EQ(unit.upload(object_of(947), 63).number(), 0U);
  EXPECT_EQ(unit.upload(object_of(947), 64).abort_code, kNoSubIndex);
}

TEST(ParameterWindow, MovesByTenThousandNumbers) {
  WindowUnit unit;

  unit.open(2, 0, 1);
  EXPECT_EQ(unit.upload(object_of(2)).abort_code, kNoObject);
  unit.open(2, 0, 5);
  EXPECT_EQ(unit.upload(object_of(9999)).abort_code, kNoObject);
  EXPECT_EQ(unit.download(kWindow, 1, 4, 2), kInvalidValue);
  EXPECT_EQ(unit.download(kWindow, 2, 6, 2), kInvalidValue);
  EXPECT_EQ(unit.upload(kWindow, 2).number(), 5U);
}

TEST(ParameterWindow, TransfersEveryTypeInItsSize) {
  WindowUnit unit;
  unit.open(2);

  EXPECT_EQ(unit.upload(object_of(2)).bytes.size(), 2U);
  EXPECT_EQ(unit.upload(object_of(8700), 0).bytes.size(), 4U);
  EXPECT_NEAR(real(unit.upload(object_of(1082))), unit.device.axis().read(1082).value(), 1e-3);
  EXPECT_EQ(unit.download(object_of(8791), 0, 0xFFFF, 2), 0U);
  EXPECT_EQ(unit.device.axis().read(8791).value(), -1.0);
  EXPECT_EQ(unit.download(object_of(1121), 0, bits(2.5), 4), 0U);
  EXPECT_EQ(real(unit.upload(object_of(1121))), 2.5);
}

TEST(ParameterWindow, RefusesAnotherLength) {
  WindowUnit unit;
  unit.open(2);

  for (const unsigned size : {1U, 2U, 3U}) EXPECT_EQ(unit.download(object_of(1121), 0, 0, size), kWrongLength);
  for (const unsigned size : {1U, 3U, 4U}) EXPECT_EQ(unit.download(object_of(8791), 0, 0, size), kWrongLength);
  EXPECT_EQ(unit.download(kWindow, 0, 2, 4), kWrongLength);
}

TEST(ParameterWindow, TakesAValueWithoutASize) {
  WindowUnit unit;
  unit.open(2);

  EXPECT_EQ(unit.says("605#2257420002000000"), Lines{"585#6057420000000000"});  // p8791 = 2

  EXPECT_EQ(unit.device.axis().read(8791).value(), 2.0);
}

TEST(ParameterWindow, AnswersARefusedParameterWithItsAbortCode) {
  WindowUnit unit;
  unit.open(2);

  EXPECT_EQ(unit.download(object_of(2), 0, 0, 2), kReadOnly);
  EXPECT_EQ(unit.download(object_of(2), 1, 0, 2), kNoSubIndex);
  EXPECT_EQ(unit.download(object_of(8791), 1, 0, 2), kNoSubIndex);
  EXPECT_EQ(unit.download(object_of(8791), 0, 4, 2), kTooHigh);
  EXPECT_EQ(unit.download(object_of(8791), 0, 0xFFFE, 2), kTooLow);
  EXPECT_EQ(unit.download(object_of(1121), 0, bits(-1.0), 4), kTooLow);
  EXPECT_EQ(unit.download(object_of(1121), 0, 0x7FC00000, 4), kTooLow);   // not a number
  EXPECT_EQ(unit.download(object_of(1121), 0, 0x7F800000, 4), kTooHigh);  // infinite
  EXPECT_EQ(unit.download(object_of(10), 0, 77, 2), kInvalidValue);
  EXPECT_EQ(unit.download(object_of(304), 0, bits(400.0), 4), kDeviceState);   // p0010 = 0
  EXPECT_EQ(unit.download(object_of(1070), 0, 0xFFFFFFFF, 4), kInvalidValue);  // no such source
}

TEST(ParameterWindow, RefusesWithThePulsesEnabledWhatNeedsThemOff) {
  TestUnit unit;
  unit.enable();
  ASSERT_EQ(unit.download(kWindow, 0, 2, 2), 0U);

  EXPECT_EQ(unit.download(object_of(8641), 0, 1, 2), kDeviceState);
  EXPECT_EQ(unit.download(object_of(1121), 0, bits(3.0), 4), 0U);
}

TEST(ParameterWindow, GivesTheRefusalOfTheObjectThatAParameterIs) {
  WindowUnit unit;
  unit.open(2);

  EXPECT_EQ(unit.download(object_of(8710), 0, 0x60410010, 4), kDeviceState);  // the RPDO is valid
  ASSERT_EQ(unit.download(object_of(8700), 0, 0x80000205, 4), 0U);
  EXPECT_EQ(unit.download(object_of(8710), 0, 0x60410010, 4), 0x06040041U);  // not mappable
  EXPECT_EQ(unit.download(object_of(8700), 0, 0x00000185, 4), 0x06040043U);  // taken
  EXPECT_EQ(unit.download(object_of(8700), 0, 0x00000205, 4), 0U);
  EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x205U);
}

TEST(ParameterWindow, ShowsTwoAxesWhileTheyRun) {
  TestUnit unit{
      {.node_id = 5, .axes = {{.drive = {}, .presets = {{1120, 0.1}}}, {.drive = {}, .presets = {{1120, 0.1}}}}}};
  unit.start();
  unit.passes(100ms);
  const std::array<std::uint16_t, 2> controlwords{0x6040, 0x6840}, setpoints{0x60FF, 0x68FF};
  const std::array rpm{600.0, -300.0};
  for (std::size_t i = 0; i < 2; ++i) {
    for (const std::uint32_t word : {0x6U, 0x7U, 0xFU}) {
      ASSERT_EQ(unit.download(controlwords[i], 0, word, 2), 0U);
      unit.passes(10ms);
    }
    const auto speed = static_cast<std::int32_t>(bus_speed(rpm[i]));
    ASSERT_EQ(unit.download(setpoints[i], 0, static_cast<std::uint32_t>(speed), 4), 0U);
  }
  unit.passes(1s);

  for (std::uint16_t i = 0; i < 2; ++i) {
    ASSERT_EQ(unit.download(kWindow, 0, 2U + i, 2), 0U);
    EXPECT_EQ(unit.upload(object_of(2)).number(), 0U);  // running
    EXPECT_NEAR(real(unit.upload(object_of(63))), rpm[i], 1.0);
    EXPECT_NEAR(real(unit.upload(object_of(21))), rpm[i], 2.0);
    EXPECT_NEAR(real(unit.upload(object_of(20))), rpm[i], 2.0);
    for (std::uint16_t number = 20; number <= 39; ++number) {
      const Upload upload = unit.upload(object_of(number));
      const bool exists = drive::find_parameter(drive::ObjectKind::Servo, number) != nullptr;
      EXPECT_EQ(upload.abort_code, exists ? 0U : kNoObject) << number;
    }
    for (std::uint8_t index = 0; index < 8; ++index)
      EXPECT_EQ(unit.upload(object_of(945), index).number(), 0U) << int{index};
  }
}

TEST(ParameterWindow, ShowsTheFaultBufferOfEachAxis) {
  WindowUnit unit;
  ASSERT_TRUE(unit.device.raise(2, 7900, 5, unit.now));

  unit.open(3);
  EXPECT_EQ(unit.upload(object_of(945), 0).number(), 7900U);
  EXPECT_EQ(unit.upload(object_of(949), 0).number(), 5U);
  EXPECT_EQ(unit.upload(object_of(945), 8).number(), 0U);
  unit.open(2);
  EXPECT_EQ(unit.upload(object_of(945), 0).number(), 0U);
}

TEST(ParameterWindow, AcknowledgesByParameter) {
  WindowUnit unit;
  ASSERT_TRUE(unit.device.raise(2, 7900, 5, unit.now));
  unit.passes(20ms);
  unit.open(3);

  EXPECT_EQ(unit.says("605#2F8D2F0001000000"), (Lines{"585#608D2F0000000000", "085#0000000000000000"}));

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.upload(object_of(3981)).number(), 0U);
}

TEST(ParameterWindow, ShowsAWrittenParameterInItsProfileObject) {
  WindowUnit unit;
  unit.open(3);

  ASSERT_EQ(unit.download(object_of(8791), 0, 2, 2), 0U);

  EXPECT_EQ(unit.upload(0x685D).number(), 2U);
}

}  // namespace
}  // namespace device
