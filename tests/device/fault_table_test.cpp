/// Every message of the unit on every drive object that can have it: on the bus, in the parameters, and each way
/// to acknowledge it. That the table is the list of the real unit is shown in tests/drive/message_list_test.cpp.
#include "drive/messages/fault_table.hpp"

#include <algorithm>
#include <array>

#include "libcanopen/base/little_endian.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/fakes/fault_row_names.hpp"

namespace device {
namespace {

using drive::FaultRow;

constexpr std::size_t kAxes = 2;
constexpr std::uint32_t kValue = 2;
constexpr std::array<std::uint16_t, 2> kFaultNumbers{945, 947};  // r0945, r0947

/// A message and where it comes from: 0 is the control unit, then the axes.
struct Injection {
  FaultRow row;
  std::size_t place;
};

bool can_have(std::size_t place, const FaultRow& row) {
  return row.scope == drive::Scope::Both || (place == 0) == (row.scope == drive::Scope::ControlUnit);
}

std::vector<Injection> injections() {
  std::vector<Injection> all;
  for (const FaultRow& row : drive::fault_rows())
    for (std::size_t place = 0; place <= kAxes; ++place)
      if (can_have(place, row)) all.push_back({row, place});
  return all;
}

std::vector<Injection> injections_of(drive::Kind kind) {
  std::vector<Injection> all = injections();
  std::erase_if(all, [=](const Injection& injection) { return injection.row.kind != kind; });
  return all;
}

class Messages : public testing::TestWithParam<Injection> {
 protected:
  Messages() {
    unit.start();
    unit.passes(100ms);
  }

  static Configuration servo_and_vector() {
    Configuration configuration = unit_with({});
    configuration.axes.resize(kAxes);
    configuration.axes.back().drive.kind = drive::ObjectKind::Vector;
    return configuration;
  }
  bool is_alarm() const { return row.kind == drive::Kind::Alarm; }
  std::uint16_t code() const {
    return drive::FaultEntry{.row = &row, .value = kValue, .kind = row.kind}.emcy_code();
  }

  /// The drive objects on which the message appears, in the order in which they get it.
  std::vector<std::size_t> owners() const {
    std::vector<std::size_t> places{place};
    for (std::size_t other = 0; other <= kAxes; ++other) {
      const bool spreads = row.propagation == drive::Propagation::Global && can_have(other, row);
      if (other != place && spreads) places.push_back(other);
    }
    return places;
  }
  /// The drive object numbers that the bus hears of: of an alarm once, for the unit.
  std::vector<std::uint8_t> reported() const {
    std::vector<std::uint8_t> objects;
    if (code() == 0) return objects;
    if (is_alarm()) return {1};
    for (const std::size_t owner : owners()) objects.push_back(static_cast<std::uint8_t>(owner + 1));
    return objects;
  }
  Lines expected_emcy() const {
    Lines lines;
    for (const std::uint8_t object : reported()) {
      canopen::Frame frame{.id = 0x085, .length = 8};
      canopen::store(&frame.data[0], code());
      frame.data[2] = row.error_register;
      canopen::store(&frame.data[3], row.number);
      frame.data[5] = object;
      lines.push_back(fakes::candump(frame));
    }
    return lines;
  }
  void inject() {
    ASSERT_TRUE(unit.device.raise(place, row.number, kValue, unit.now));
    EXPECT_EQ(unit.passes(100ms), expected_emcy());
  }
  double parameter(std::size_t owner, std::uint16_t number) const {
    return unit.device.unit().object(static_cast<std::uint8_t>(owner + 1))->read(number).value_or(-1.0);
  }
  void expect_parameters() const {
    for (const std::size_t owner : owners()) {
      for (const std::uint16_t number : kFaultNumbers)
        EXPECT_EQ(parameter(owner, number), is_alarm() ? 0 : row.number);
      EXPECT_EQ(parameter(owner, 949), is_alarm() ? 0 : kValue);
      EXPECT_EQ(parameter(owner, 2122), is_alarm() ? row.number : 0);
      EXPECT_EQ(parameter(owner, 2124), is_alarm() ? kValue : 0);
    }
  }
  bool has_alarms(std::size_t owner) const {
    return !unit.device.unit().object(static_cast<std::uint8_t>(owner + 1))->messages().alarms().empty();
  }
  std::uint16_t status(std::size_t axis) {
    return static_cast<std::uint16_t>(
        unit.upload(static_cast<std::uint16_t>(0x6041 + 0x800 * (axis - 1))).number());
  }
  void expect_statuswords() {
    const auto places = owners();
    for (std::size_t axis = 1; axis <= kAxes; ++axis) {
      const bool has = std::ranges::find(places, axis) != places.end();
      EXPECT_EQ(status(axis) & 0x0088, !has ? 0 : is_alarm() ? 0x0080 : 0x0008) << axis;
    }
  }
  void expect_error_field() {
    const auto objects = reported();
    EXPECT_EQ(unit.upload(0x1001).number(), row.error_register);
    EXPECT_EQ(unit.upload(0x1003, 0).number(), objects.size());
    EXPECT_EQ(unit.upload(0x1003, 1).number(), objects.empty() ? 0 : std::uint64_t{objects.back()} << 16 | code());
    for (std::uint8_t object = 1; object <= kAxes + 1; ++object) {
      const unsigned block = object == 1 ? 0x4A : 0x02 + 9U * (object - 2);
      const bool has = std::ranges::find(objects, object) != objects.end();
      EXPECT_EQ(unit.upload(0x1003, static_cast<std::uint8_t>(block)).number(), has ? 1U : 0U) << int{object};
      EXPECT_EQ(unit.upload(0x1003, static_cast<std::uint8_t>(block + 1)).number(),
                has ? std::uint64_t{row.number} << 16 | code() : 0U);
    }
  }
  /// Bit 7 of the controlword of every axis that has the message; what the unit has sent last.
  Lines acknowledge_with_controlwords() {
    for (const std::size_t owner : owners()) {
      if (owner == 0) continue;
      const auto index = static_cast<std::uint16_t>(0x6040 + 0x800 * (owner - 1));
      for (const std::uint32_t word : {0x00U, 0x80U}) EXPECT_EQ(unit.download(index, 0, word, 2), 0U);
    }
    return unit.passes(20ms);
  }
  /// p3981 of every drive object that has the message; what the unit has sent last.
  Lines acknowledge_with_parameters() {
    constexpr std::uint16_t kWindow = 0x2000 + 8630, kAcknowledge = 0x2000 + 3981;
    Lines sent;
    for (const std::size_t owner : owners()) {
      EXPECT_EQ(unit.download(kWindow, 0, static_cast<std::uint32_t>(owner + 1), 2), 0U);
      EXPECT_EQ(unit.upload(kAcknowledge).number(), 0U);
      sent = unit.says("605#2F8D2F0001000000");
    }
    return sent;
  }
  /// The message has left every drive object, or stays on all of them until the power is switched off.
  void expect_acknowledged(const Lines& sent) {
    const bool stays = row.acknowledge == drive::Acknowledge::PowerOn;
    const Lines gone{"085#0000000000000000"};
    EXPECT_EQ(from("085#", sent), stays || code() == 0 ? Lines{} : gone);
    for (const std::size_t owner : owners()) {
      EXPECT_EQ(parameter(owner, 945), stays ? row.number : 0);
      EXPECT_FALSE(has_alarms(owner));
    }
    EXPECT_EQ(unit.upload(0x1003, 0).number(), stays ? reported().size() : 0U);
  }

  const FaultRow row = GetParam().row;
  const std::size_t place = GetParam().place;
  TestUnit unit{servo_and_vector()};
};
class Faults : public Messages {};
class Alarms : public Messages {};

TEST_P(Messages, AreShownOnTheBusAndInTheParameters) {
  inject();

  expect_parameters();
  expect_statuswords();
  expect_error_field();
}

TEST_P(Messages, LeaveWithZeroInTheErrorField) {
  inject();

  expect_acknowledged(unit.says("605#2F03100000000000"));
}

TEST_P(Faults, LeaveAxesWithTheEdgeOfTheControlword) {
  inject();
  const auto places = owners();
  const Lines sent = acknowledge_with_controlwords();

  const bool stays = row.acknowledge == drive::Acknowledge::PowerOn;
  for (const std::size_t owner : places) EXPECT_EQ(parameter(owner, 945), owner == 0 || stays ? row.number : 0);
  const bool all_gone = !stays && std::ranges::find(places, 0U) == places.end();
  EXPECT_EQ(from("085#", sent).size(), all_gone ? 1U : 0U);
}

TEST_P(Faults, LeaveOneDriveObjectAfterTheOtherByItsParameter) {
  inject();

  expect_acknowledged(acknowledge_with_parameters());
}

TEST_P(Alarms, StayWithTheEdgeOfTheControlword) {
  inject();

  EXPECT_EQ(from("085#", acknowledge_with_controlwords()), Lines{});
  expect_parameters();
  expect_error_field();
}

TEST_P(Alarms, StayWithTheParameterThatAcknowledges) {
  inject();

  EXPECT_EQ(from("085#", acknowledge_with_parameters()), Lines{});
  expect_parameters();
  expect_error_field();
}

TEST_P(Messages, LeaveOneDriveObjectAfterTheOtherFromOutside) {
  inject();
  const bool stays = row.acknowledge == drive::Acknowledge::PowerOn;

  for (const std::size_t owner : owners()) EXPECT_EQ(unit.device.acknowledge(owner, unit.now), !stays);

  expect_acknowledged(unit.passes(0ms));
}

TEST_P(Messages, LeaveWithAResetOfTheNode) {
  inject();

  unit.says("000#8105");

  for (const std::size_t owner : owners()) {
    EXPECT_EQ(parameter(owner, 945), 0.0);
    EXPECT_FALSE(has_alarms(owner));
  }
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

std::string name_of(const testing::TestParamInfo<Injection>& injection) {
  static const std::vector<std::string> kPlaces{"Unit", "Servo", "Vector"};
  return drive::fault_text(injection.param.row) + "On" + kPlaces[injection.param.place];
}

INSTANTIATE_TEST_SUITE_P(Unit, Messages, testing::ValuesIn(injections()), name_of);
INSTANTIATE_TEST_SUITE_P(Unit, Faults, testing::ValuesIn(injections_of(drive::Kind::Fault)), name_of);
INSTANTIATE_TEST_SUITE_P(Unit, Alarms, testing::ValuesIn(injections_of(drive::Kind::Alarm)), name_of);

TEST(UnknownMessages, AreRefused) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.device.raise(1, 1, 0, unit.now), tl::unexpected{drive::FaultError::Unknown});
  for (const FaultRow& row : drive::fault_rows()) {
    const bool of_the_unit = row.scope == drive::Scope::ControlUnit;
    if (row.scope == drive::Scope::Both) continue;
    EXPECT_EQ(unit.device.raise(of_the_unit ? 1 : 0, row.number, 0, unit.now),
              tl::unexpected{drive::FaultError::NotOnThisAxis});
  }
  EXPECT_EQ(unit.passes(100ms), Lines{});
}

}  // namespace
}  // namespace device
