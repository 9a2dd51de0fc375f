#include <array>
#include <cstdio>

#include "tests/device/pdo_rules_fixture.hpp"

/// The rules of the unit for PDO parameters: each refusal has its abort code and its alarm.
namespace device {
namespace {

/// The EMCY of alarm @p number with drive object 1.
std::string emergency(std::uint16_t number) {
  std::array<char, 32> line{};
  std::snprintf(line.data(), line.size(), "085#011011%02X%02X010000", number & 0xFFU, unsigned{number} >> 8);
  return line.data();
}

/// Index @p index of parameter @p number of a drive object (control unit 1, axes from 2).
std::uint32_t parameter(const TestUnit& unit, std::uint8_t object, std::uint16_t number, std::size_t index) {
  const auto value = unit.device.unit().read(object, number, index);
  return value ? value->bits : 0xDEAD;
}

/// A refused write: the abort code, the alarm that comes with one EMCY after the answer, and its value.
struct Refused {
  std::uint32_t abort_code;
  std::uint16_t alarm;
  std::uint32_t value = 0;
};

/// @p write is refused, and the alarm is seen by EMCY, 1003h, and r2122 of every drive object.
void expect_refused(TestUnit& unit, const Write& write, const Refused& refused) {
  SCOPED_TRACE(request(write));
  const Lines lines = unit.says(request(write));
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[0].substr(0, 6), "585#80");
  const auto code = static_cast<std::uint32_t>(std::stoul(lines[0].substr(12), nullptr, 16));
  EXPECT_EQ(__builtin_bswap32(code), refused.abort_code);
  EXPECT_EQ(lines[1], emergency(refused.alarm));
  EXPECT_EQ(from("085#", lines).size(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 1).number(), 0x00011001U) << "most recent: drive object 1, code 1001h";
  const auto count = unit.upload(0x1003, 0x4A).number();
  EXPECT_EQ(unit.upload(0x1003, static_cast<std::uint8_t>(0x4A + count)).number(), refused.alarm << 16 | 0x1001U);
  for (std::size_t axis = 0; axis <= unit.device.unit().axes().size(); ++axis) {
    const auto alarms = unit.device.unit().object(static_cast<std::uint8_t>(axis + 1))->messages().alarms();
    ASSERT_FALSE(alarms.empty()) << axis;
    EXPECT_EQ(alarms.back().row->number, refused.alarm) << axis;
    EXPECT_EQ(alarms.back().value, refused.value) << axis;
  }
}

// The online mapping of the manual for axis 3: controlword, speed and torque in one RPDO. Each step is left out
// once, each time with the refusal that belongs to it.
TEST(PdoRules, LeadThroughTheOnlineMappingOfTheManual) {
  TestUnit unit{unit_of(3)};
  unit.start();
  expect_accepted(unit, {0x1480, 1, 0x213});

  unit.says("000#0105");
  expect_refused(unit, {0x1480, 1, kInvalid | 0x213}, {0x08000022, 8754});
  EXPECT_EQ(unit.says("000#8005"), Lines{"085#0000000000000000"}) << "the alarm ends with the NMT state";
  expect_no_alarm(unit);

  expect_refused(unit, {0x1680, 2, 0x70FF0020}, {0x08000022, 8757});
  expect_accepted(unit, {0x1480, 1, kInvalid | 0x213});
  expect_no_alarm(unit);
  expect_refused(unit, {0x1680, 1, 0x60400010}, {0x06040041, 8755});
  expect_accepted(unit, {0x1680, 1, 0x70400010});
  expect_no_alarm(unit);
  expect_accepted(unit, {0x1680, 2, 0x70FF0020});
  expect_accepted(unit, {0x1680, 3, 0x70710010});
  expect_refused(unit, {0x1680, 4, 0x59000010}, {0x06040042, 8756});
  expect_refused(unit, {0x1480, 1, 0x305}, {0x06040043, 8759, 8700});
  expect_accepted(unit, {0x1480, 1, 0x213});
  expect_no_alarm(unit);

  EXPECT_EQ(parameter(unit, 4, 8750, 0), 0x7040U);
  EXPECT_EQ(parameter(unit, 4, 8750, 1), 0U);
  EXPECT_EQ(parameter(unit, 4, 8760, 1), 0x70FFU);
  EXPECT_EQ(parameter(unit, 4, 8760, 2), 0U);
  EXPECT_EQ(parameter(unit, 4, 8750, 3), 0x7071U);
  expect_accepted(unit, {0x41B6, 0, 4, 2});  // the parameters of drive object 4 from 2000h
  EXPECT_EQ(unit.upload(0x2000 + 8750, 3).number(), 0x7071U);
  EXPECT_EQ(unit.upload(0x2000 + 8760, 1).number(), 0x70FFU);
  unit.says("000#0105");
  unit.says("213#0600000080F4010C");
  EXPECT_EQ(unit.upload(0x7040).number(), 0x0006U);
  EXPECT_EQ(unit.upload(0x70FF).number(), 0xF4800000U);
  EXPECT_EQ(unit.upload(0x7071).number(), 0x0C01U);
}

TEST(PdoRules, PlaceTheObjectsOfTheFirstAxisAsTheManualDoes) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(parameter(unit, 2, 8750, 0), 0x6040U);
  EXPECT_EQ(parameter(unit, 2, 8760, 1), 0x60FFU);
  EXPECT_EQ(parameter(unit, 2, 8750, 3), 0x6071U);
  EXPECT_EQ(parameter(unit, 2, 8751, 0), 0x6041U);
  EXPECT_EQ(parameter(unit, 2, 8761, 1), 0x606CU);
  EXPECT_EQ(parameter(unit, 2, 8751, 3), 0x6077U);
  EXPECT_EQ(parameter(unit, 2, 8761, 4), 0x6063U);
}

TEST(PdoRules, AllowNoMoreThanTwentyFiveValidRpdos) {
  TestUnit unit{unit_of(8)};
  unit.start();
  std::uint32_t valid = 4;  // of the predefined connection set
  const auto rpdo = [](std::uint32_t number) {
    return Write{static_cast<std::uint16_t>(0x1440 + number / 8 * 0x40 + number % 8), 1, 0x410 + number};
  };
  for (std::uint32_t number = 0; valid < 25; ++number, ++valid) {
    EXPECT_EQ(parameter(unit, 1, 8742, 0), 25 - valid);
    expect_accepted(unit, rpdo(number));
  }

  EXPECT_EQ(parameter(unit, 1, 8742, 0), 0U);
  expect_refused(unit, rpdo(40), {0x06040047, 8758, 1});
  expect_accepted(unit, {0x1403, 1, kInvalid | 0x505});
  expect_no_alarm(unit);
  expect_accepted(unit, rpdo(40));
}

TEST(PdoRules, AllowAsManyValidTpdosAsTheSamplingTimesLeaveTime) {
  struct Case {
    drive::ObjectKind kind;
    std::uint32_t most;  // p8848 over p0115[0]: 4 ms over 125 us or 250 us
  };
  for (const auto& [kind, most] : {Case{drive::ObjectKind::Servo, 32}, Case{drive::ObjectKind::Vector, 16}}) {
    TestUnit unit{unit_of(8, kind)};
    unit.start();
    const auto tpdo = [](std::uint32_t number) {
      return Write{static_cast<std::uint16_t>(0x1840 + number / 8 * 0x40 + number % 8), 1, 0x210 + number};
    };
    for (std::uint32_t number = 0; number + 4 < most; ++number) {
      EXPECT_EQ(parameter(unit, 1, 8742, 1), most - 4 - number);
      expect_accepted(unit, tpdo(number));
    }
    EXPECT_EQ(parameter(unit, 1, 8742, 1), 0U);
    expect_refused(unit, tpdo(50), {0x06040047, 8758, 2});
  }
}

TEST(PdoRules, KeepAnAlarmUntilItIsCleared) {
  const Write mapping{0x1600, 1, 0x60400010};
  TestUnit unit{unit_of(2)};
  unit.start();
  const Refused refused{0x08000022, 8757};

  expect_refused(unit, mapping, refused);
  expect_accepted(unit, {0x1003, 0, 0, 1});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U) << "an alarm is not acknowledged";
  EXPECT_EQ(unit.download(mapping.index, mapping.sub_index, mapping.value, 4), 0x08000022U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U) << "it is the same alarm";

  unit.says("000#0205");
  unit.says("000#8005");
  expect_no_alarm(unit);
  expect_refused(unit, mapping, refused);
  unit.says("000#8105");
  expect_no_alarm(unit);
  expect_refused(unit, mapping, refused);
  unit.says("000#8205");
  expect_no_alarm(unit);
}

TEST(PdoRules, EndWhereTheProcessDataOfAnAxisAreFull) {
  TestUnit unit{unit_of(2)};
  unit.start();
  // 6040h, 60FFh and 6071h take four words of twenty.
  for (std::uint32_t word = 0; word < 16; ++word)
    expect_accepted(unit, {static_cast<std::uint16_t>(0x1644 + word / 4), static_cast<std::uint8_t>(word % 4 + 1),
                           (0x5880 + word) << 16 | 0x10});
  EXPECT_EQ(parameter(unit, 3, 8750, 4), 0x5880U);
  EXPECT_EQ(parameter(unit, 3, 8750, 15), 0x588BU);
  expect_accepted(unit, {0x1647, 4, 0});
  expect_refused(unit, {0x1640, 2, 0x58A00020}, {0x06040047, 8760, 1});
  expect_accepted(unit, {0x1647, 4, 0x60400010 + 0x08000000});  // has its place already
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  expect_accepted(unit, {0x1447, 1, kInvalid});
  expect_no_alarm(unit);

  // 6041h, 606Ch, 6077h and 6063h take six words of twenty-five.
  for (std::uint32_t word = 0; word < 8; ++word)
    expect_accepted(unit, {static_cast<std::uint16_t>(0x1A44 + word / 2), static_cast<std::uint8_t>(word % 2 + 1),
                           (0x58B0 + word) << 16 | 0x20});
  expect_accepted(unit, {0x1A40, 2, 0x58900010});
  expect_accepted(unit, {0x1A40, 3, 0x58910010});
  expect_accepted(unit, {0x1A40, 4, 0x58920010});
  expect_refused(unit, {0x1A41, 3, 0x58930010}, {0x06040047, 8760, 2});
}

TEST(PdoRules, HoldForParametersAsForObjects) {
  TestUnit unit{unit_of(2)};
  unit.start();
  expect_accepted(unit, {0x41B6, 0, 2, 2});
  const auto parameter_at = [](std::uint16_t number) { return static_cast<std::uint16_t>(0x2000 + number); };

  expect_refused(unit, {parameter_at(8713), 1, 0x60FF0020}, {0x08000022, 8757});
  expect_accepted(unit, {parameter_at(8703), 0, kInvalid});
  expect_no_alarm(unit);
  expect_refused(unit, {parameter_at(8713), 3, 0x68FF0020}, {0x06040041, 8755});
  expect_refused(unit, {parameter_at(8703), 0, 0x305}, {0x06040043, 8759, 8703});
  EXPECT_EQ(unit.upload(parameter_at(8741)).number(), 0U);
  expect_accepted(unit, {parameter_at(8741), 0, 1, 2});
  expect_no_alarm(unit);
  EXPECT_EQ(unit.upload(0x1403, 1).number(), 0x505U);
  unit.says("000#0105");
  expect_refused(unit, {parameter_at(8741), 0, 1, 2}, {0x08000022, 8754});
}

}  // namespace
}  // namespace device
