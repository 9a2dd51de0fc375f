// A motor that is not what its data sheet says, commissioned over the bus as a person at a terminal does it.
#include <array>
#include <bit>
#include <cmath>
#include <csignal>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

constexpr double kResistance = 1.2, kInductance = 0.85, kFlux = 1.1;
constexpr double kMotorInertia = 0.00151, kLoadInertia = 5.0 * kMotorInertia;

/// Another specimen of the motor, with a heavy load, behind a power unit with dead time.
const nlohmann::json kSpecimen{{"plant",
                                {{"stator_resistance", kResistance},
                                 {"d_inductance", kInductance},
                                 {"q_inductance", kInductance},
                                 {"magnet_flux", kFlux}}},
                               {"load", {{"inertia", kLoadInertia}}},
                               {"power_unit", {{"rated_current_A", 18}, {"dead_time_us", 1.5}}},
                               {"parameters", {{"p1120", 1.0}, {"p1121", 1.0}}}};

/// A value of the rating plate and the parameter for it; of the load (p0342) nothing is known.
struct PlateValue {
  std::uint16_t parameter;
  float value;
};
constexpr std::array kPlate{PlateValue{304, 330.0F},  PlateValue{305, 5.6F},    PlateValue{307, 2.293F},
                            PlateValue{310, 200.0F},  PlateValue{311, 3000.0F}, PlateValue{316, 1.37F},
                            PlateValue{322, 7200.0F}, PlateValue{323, 28.0F},   PlateValue{342, 1.0F}};
/// Of the data sheet, behind what the plate alone would give.
constexpr PlateValue kRotorInertia{341, 0.00151F};

struct Step {
  const char* frame;
  DriveState state;
};
// Bit 7 of the statusword.
constexpr DriveState kAlarm{"alarm", 0x80, 0x80}, kNoAlarm{"no alarm", 0x80, 0x00};
constexpr std::array kSwitchOn{Step{"205#0600", kReadyToSwitchOn}, Step{"205#0700", kSwitchedOn},
                               Step{"205#0F00", kOperationEnabled}};

struct Commissioning : testing::Test {
  static constexpr std::uint16_t kFilter = 10, kCalculation = 340, kStandstill = 1910, kRotating = 1960;

  static constexpr std::chrono::seconds kLongest{120};  // of a measurement

  CanClient can{kTestInterface};
  BusSdoClient sdo;
  DaemonProcess daemon{{.axis = kSpecimen}};

  void SetUp() override {
    ASSERT_TRUE(daemon.is_ready());
    can.listen_to({0x285});
    open_window();
  }
  /// The objects 2000h to 470Fh are the parameters of the axis.
  void open_window() { ASSERT_EQ(sdo.download(0x41B6, 0, 2, 2), 0U); }
  void write(std::uint16_t parameter, std::uint16_t value) {
    ASSERT_EQ(sdo.download(0x2000U + parameter, 0, value, 2), 0U) << 'p' << parameter;
  }
  void write(const PlateValue& row) {
    ASSERT_EQ(sdo.download(0x2000U + row.parameter, 0, std::bit_cast<std::uint32_t>(row.value), 4), 0U)
        << 'p' << row.parameter;
  }
  std::uint64_t number(std::uint16_t parameter, std::uint8_t index = 0) {
    return sdo.upload(0x2000U + parameter, index).number();
  }
  /// The alarm becomes active and stands in the buffer.
  bool shows(std::uint16_t alarm) {
    if (!sdo.comes_to(0x6041, kAlarm)) return false;
    std::uint8_t index = 0;
    while (index < 8 && number(2122, index) != alarm) ++index;
    return index < 8;
  }
  double real(std::uint16_t parameter) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(number(parameter)));
  }
  void put_in_rating_plate() {
    ASSERT_NO_FATAL_FAILURE(write(kFilter, 3));
    for (const PlateValue& row : kPlate) ASSERT_NO_FATAL_FAILURE(write(row));
    ASSERT_NO_FATAL_FAILURE(write(kCalculation, 1));
    ASSERT_EQ(number(kCalculation), 0U) << "done";
    ASSERT_NO_FATAL_FAILURE(write(kRotorInertia));
    ASSERT_NO_FATAL_FAILURE(write(kCalculation, 3));
    ASSERT_NO_FATAL_FAILURE(write(kFilter, 0));
  }
  /// From Switch on disabled to Operation enabled.
  void switch_on() {
    for (const Step& step : kSwitchOn) {
      can.send(step.frame);
      ASSERT_TRUE(sdo.comes_to(0x6041, step.state)) << step.frame;
    }
  }
  /// Selects the measurement @p parameter and lets it lead until its end.
  void measure(std::uint16_t parameter, std::uint16_t alarm) {
    ASSERT_NO_FATAL_FAILURE(write(parameter, 1));
    EXPECT_TRUE(shows(alarm)) << "it waits for ON";
    ASSERT_NO_FATAL_FAILURE(switch_on());
    EXPECT_NE(number(47), 0U) << "its progress";
    ASSERT_TRUE(sdo.comes_to(0x6041, kSwitchOnDisabled, kLongest));
    EXPECT_EQ(number(945), 0U) << "no fault";
    EXPECT_EQ(number(parameter), 0U);
    EXPECT_TRUE(sdo.comes_to(0x6041, kNoAlarm));
  }
};

void expect_near(double value, double wanted, double share, const char* what) {
  EXPECT_LT(std::abs(value / wanted - 1.0), share) << what << ": " << value << " instead of " << wanted;
}

TEST_F(Commissioning, FindsTheSpecimenSavesItAndLetsItRun) {
  can.send("000#0105");
  ASSERT_NO_FATAL_FAILURE(put_in_rating_plate());
  const double gain_before = real(1460);

  ASSERT_NO_FATAL_FAILURE(measure(kStandstill, 7991));
  ASSERT_NO_FATAL_FAILURE(measure(kRotating, 7980));

  expect_near(real(350), kResistance * 0.55, 0.02, "p0350");
  expect_near(real(356), kInductance * 5.5, 0.03, "p0356");
  expect_near(real(341) * real(342), kMotorInertia + kLoadInertia, 0.02, "p0341 p0342");
  EXPECT_GT(real(1460), 3.0 * gain_before);

  ASSERT_EQ(sdo.download(0x1010, 1, 0x65766173, 4), 0U);
  ASSERT_NO_FATAL_FAILURE(switch_on());
  can.send("305#0F000000800C");
  EXPECT_TRUE(wait_for_drive(can, "3000 rpm", [](const StatusAndSpeed& drive) {
    constexpr std::int32_t kFullSpeed = 0x0C800000;
    return std::abs(drive.speed - kFullSpeed) < kFullSpeed / 500 && drive.has(kTargetReached);
  }));

  const std::uint64_t resistance = number(350);
  ASSERT_EQ(daemon.end(SIGTERM), 0);
  daemon.start();
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_NO_FATAL_FAILURE(open_window());
  EXPECT_EQ(number(350), resistance);
}

TEST_F(Commissioning, OffInTheMiddleLeavesWhatWas) {
  can.send("000#0105");
  const std::uint64_t resistance = number(350);
  ASSERT_NO_FATAL_FAILURE(write(kStandstill, 1));
  ASSERT_NO_FATAL_FAILURE(switch_on());

  can.send("205#0000");

  ASSERT_TRUE(sdo.comes_to(0x6041, kSwitchOnDisabled));
  EXPECT_EQ(number(350), resistance);
  EXPECT_EQ(number(kStandstill), 1U) << "the next ON begins anew";
}

}  // namespace
}  // namespace e2e
