// Objects, words of process data and quantities of the drive, at their limits too.
#include <bit>
#include <cmath>

#include "tests/device/process_data_unit.hpp"
#include "tests/device/wired_device.hpp"
#include "tests/drive/axis_inputs.hpp"

namespace device {
namespace {

constexpr std::uint32_t kControlword = 0x60400010, kVelocity = 0x60FF0020, kTorque = 0x60710010,
                        kVlVelocity = 0x60420010;
constexpr double kSpeed = 3000.0;  // rpm, p2000

/// An axis whose p2000 is 3000 rpm and whose p2003 is @p torque, given as a share of r0333.
struct Scaled : WiredDevice {
  explicit Scaled(double speed = kSpeed, double torque_share = 1.0, bool with_encoder = true)
      : WiredDevice{configuration(speed, with_encoder)} {
    EXPECT_TRUE(with_encoder || parameter(1300) == 20.0);
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(parameter(333) * torque_share));
    EXPECT_EQ(write_parameter(2, 2003, bits, 4), 0U);
    unmap_all();
    map_rpdo(1, {kControlword, kVelocity, kTorque});
    map_rpdo(2, {kVlVelocity});
    enter();
  }
  static Configuration configuration(double speed, bool with_encoder) {
    Configuration c = unit_of(1);
    c.axes[0].presets = {{2000, speed}};
    if (!with_encoder) {
      c.axes[0].drive.machine.encoder.type = motor::EncoderType::None;
      c.axes[0].presets.push_back({1300, 20});
    }
    return c;
  }
  /// What 60FFh gives: r8860[1] and p1070 (rpm).
  std::pair<std::uint32_t, double> velocity_of(std::uint32_t wanted) {
    EXPECT_EQ(download(0x60FF, 0, wanted, 4), 0U);
    cycle();
    return {read_parameter(2, 8860, 1), drive::inputs_of(device.axis()).main_setpoint / drive::kRpm};
  }
  std::pair<std::uint32_t, double> torque_of(int wanted) {
    EXPECT_EQ(download(0x6071, 0, static_cast<std::uint16_t>(wanted), 2), 0U);
    cycle();
    return {read_parameter(2, 8850, 3) & 0xFFFFU,
            drive::inputs_of(device.axis()).torque_setpoint / parameter(333)};
  }
};

struct VelocityRow {
  std::uint32_t bus, words;
  double rpm;
};

TEST(VelocityScaling, OfReceivedIncrements) {
  Scaled unit;
  for (const VelocityRow& row : std::initializer_list<VelocityRow>{{0x0C800000, 0x40000000, 3000},
                                                                   {0x06400000, 0x20000000, 1500},
                                                                   {0x00400000, 0x0147AE14, 60},
                                                                   {0x12C00000, 0x60000000, 4500},
                                                                   {0xF3800000, 0xC0000000, -3000},
                                                                   {0, 0, 0},
                                                                   {0x19000000, 0x7FFFFFFF, 6000},
                                                                   {0x7FFFFFFF, 0x7FFFFFFF, 6000},
                                                                   {0x80000000, 0x80000000, -6000},
                                                                   {0xE7000000, 0x80000000, -6000}}) {
    const auto [words, rpm] = unit.velocity_of(row.bus);
    EXPECT_EQ(words, row.words) << std::hex << row.bus;
    EXPECT_NEAR(rpm, row.rpm, 1e-5) << std::hex << row.bus;
  }
}

TEST(VelocityScaling, HasTheFactorInBothDirections) {
  Scaled unit;
  ASSERT_EQ(unit.download(0x6094, 1, 4194304, 4), 0U);
  ASSERT_EQ(unit.download(0x6094, 2, 60, 4), 0U);
  for (const int rpm : {3000, -1500, 1, 6000}) {
    const auto [words, seen] = unit.velocity_of(static_cast<std::uint32_t>(rpm));
    EXPECT_NEAR(seen, rpm, 1e-5);
    EXPECT_NEAR(static_cast<std::int32_t>(words), std::min(rpm / kSpeed * 0x40000000, 2147483647.0), 1.0);
  }
  const auto [words, seen] = unit.velocity_of(0x7FFFFFFF);
  EXPECT_EQ(words, 0x7FFFFFFFU);
  EXPECT_NEAR(seen, 6000.0, 1e-5) << "saturated, not wrapped";
}

TEST(VelocityScaling, IsRpmWithoutEncoder) {
  Scaled unit{kSpeed, 1.0, false};
  for (const VelocityRow& row :
       std::initializer_list<VelocityRow>{{3000, 0x40000000, 3000},
                                          {static_cast<std::uint32_t>(-1500), 0xE0000000, -1500},
                                          {0x7FFFFFFF, 0x7FFFFFFF, 6000}}) {
    const auto [words, rpm] = unit.velocity_of(row.bus);
    EXPECT_EQ(words, row.words) << std::hex << row.bus;
    EXPECT_NEAR(rpm, row.rpm, 1e-5) << std::hex << row.bus;
  }
  ASSERT_EQ(unit.download(0x6094, 1, 1, 4), 0U);
  ASSERT_EQ(unit.download(0x6094, 2, 100, 4), 0U);
  EXPECT_NEAR(unit.velocity_of(150000).second, 1500.0, 1e-5);
}

TEST(RampScaling, HasTheUnitOfTheVelocity) {
  for (const bool with_encoder : {true, false}) {
    Scaled unit{kSpeed, 1.0, with_encoder};
    ASSERT_EQ(unit.write_parameter(2, 1082, std::bit_cast<std::uint32_t>(3000.0F), 4), 0U);
    if (with_encoder) {
      EXPECT_EQ(unit.upload(0x6083).number(), 20971520U);
      ASSERT_EQ(unit.download(0x6094, 1, 4194304, 4), 0U);
      ASSERT_EQ(unit.download(0x6094, 2, 60, 4), 0U);
    }
    EXPECT_EQ(unit.upload(0x6083).number(), 300U) << "3000 rpm in 10 s, in rpm/s";
    for (const auto& [index, parameter] :
         {std::pair{0x6083, 1120}, std::pair{0x6084, 1121}, std::pair{0x6085, 1135}}) {
      const auto object = static_cast<std::uint16_t>(index);
      const auto time = [&, number = static_cast<std::uint16_t>(parameter)] { return unit.parameter(number); };
      ASSERT_EQ(unit.download(object, 0, 600, 4), 0U);
      EXPECT_NEAR(time(), 5.0, 1e-5);
      EXPECT_EQ(unit.upload(object).number(), 600U);
      ASSERT_EQ(unit.download(object, 0, 1, 4), 0U);
      EXPECT_NEAR(time(), parameter == 1135 ? 600.0 : 3000.0, 1e-3) << "clipped to the range of the parameter";
      ASSERT_EQ(unit.download(object, 0, 0xFFFFFFFE, 4), 0U);
      EXPECT_GT(time(), 0.0);
    }
  }
}

TEST(RampScaling, SaturatesAtTheEndOfTheObject) {
  WiredDevice unit;
  ASSERT_EQ(unit.write_parameter(2, 1082, std::bit_cast<std::uint32_t>(3000.0F), 4), 0U);
  ASSERT_EQ(unit.write_parameter(2, 1120, std::bit_cast<std::uint32_t>(0.01F), 4), 0U);
  EXPECT_EQ(unit.upload(0x6083).number(), 0xFFFFFFFFU);
}

TEST(VelocityScaling, IsRelativeToP2000) {
  Scaled unit{1200.0};
  const auto [words, rpm] = unit.velocity_of(0x0C800000);
  EXPECT_EQ(words, 0x7FFFFFFFU);
  EXPECT_NEAR(rpm, 2400.0, 1e-5) << "200 % of p2000";
  const auto [half, slow] = unit.velocity_of(0x02800000);
  EXPECT_EQ(half, 0x20000000U);
  EXPECT_NEAR(slow, 600.0, 1e-5);
}

TEST(VelocityScaling, IsWholeIncrementsWithoutPlace) {
  Scaled unit{1200.0};
  unit.leave();
  unit.map_rpdo(1, {kControlword});
  ASSERT_EQ(unit.download(0x60FF, 0, 0x0C800000, 4), 0U);
  unit.cycle();
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).main_setpoint / drive::kRpm, 3000.0, 1e-5)
      << "r8796 does not saturate at p2000";
  ASSERT_EQ(unit.download(0x60FF, 0, 0x80000000, 4), 0U);
  unit.cycle();
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).main_setpoint / drive::kRpm, -30720.0, 1e-3);
}

TEST(TorqueScaling, OfReceivedPerMille) {
  Scaled unit;
  struct Row {
    int bus;
    std::uint32_t word;
    double share;
  };
  for (const Row& row : {Row{500, 0x2000, 0.5}, Row{-500, 0xE000, -0.5}, Row{1000, 0x4000, 1.0}, Row{0, 0, 0.0},
                         Row{2000, 0x7FFF, 2.0}, Row{32767, 0x7FFF, 2.0}, Row{-2000, 0x8000, -2.0},
                         Row{-32768, 0x8000, -2.0}, Row{1, 0x0010, 0.001}}) {
    const auto [word, share] = unit.torque_of(row.bus);
    EXPECT_EQ(word, row.word) << row.bus;
    EXPECT_NEAR(share, row.share, 1e-4) << row.bus;
  }
}

TEST(TorqueScaling, IsRelativeToP2003) {
  Scaled unit{kSpeed, 2.0};
  EXPECT_EQ(unit.torque_of(1000).first, 0x2000U);
  EXPECT_NEAR(unit.torque_of(3500).second, 3.5, 1e-3);
  EXPECT_NEAR(unit.torque_of(32767).second, 4.0, 1e-3) << "200 % of p2003";
}

TEST(TorqueScaling, IsPerMilleWithoutPlace) {
  Scaled unit{kSpeed, 0.5};
  unit.leave();
  unit.map_rpdo(1, {kControlword});
  ASSERT_EQ(unit.download(0x6071, 0, 1500, 2), 0U);
  unit.cycle();
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).torque_setpoint / unit.parameter(333), 1.5, 1e-5);
}

TEST(VlVelocityScaling, IsRpmAndSaturatesAtTwiceP2000) {
  Scaled unit;
  ASSERT_EQ(unit.download(0x6060, 0, 2, 1), 0U);
  for (const auto& [bus, word, rpm] : {std::tuple{1500, 0x2000U, 1500.0}, std::tuple{-3000, 0xC000U, -3000.0},
                                       std::tuple{32767, 0x7FFFU, 6000.0}, std::tuple{-32768, 0x8000U, -6000.0}}) {
    ASSERT_EQ(unit.download(0x6042, 0, static_cast<std::uint16_t>(bus), 2), 0U);
    unit.cycle();
    EXPECT_EQ(unit.read_parameter(2, 8850, 4) & 0xFFFFU, word) << bus;
    EXPECT_NEAR(drive::inputs_of(unit.device.axis()).main_setpoint / drive::kRpm, rpm, 0.2) << bus;
  }
}

/// Values of the drive that are sent: a fixed source in place of the actual value.
struct SentUnit : ProcessDataUnit {
  explicit SentUnit(double speed = kSpeed) : ProcessDataUnit{1} {
    EXPECT_TRUE(set_parameter(2, 2000, 0, speed));
    start();
    exchange();
  }
  /// Connects what sends @p index to the fixed setpoint of @p rpm; what the object shows then.
  std::int64_t shown(std::uint16_t index, double rpm) {
    const auto* const place = unit_process_data.places(1).sent().find(index);
    EXPECT_NE(place, nullptr) << std::hex << index;
    if (place == nullptr) return 0;
    EXPECT_TRUE(set_parameter(2, 1001, 0, rpm));
    EXPECT_TRUE(set_parameter(2, place->words == 1 ? 8851 : 8861, place->first, own(1001)));
    exchange();
    return dictionary.read(**dictionary.find(index, 0)).value();
  }
};

TEST(SentVelocity, IsIncrementsOfTheWholeRange) {
  for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x606C, 0x6069, 0x606B}) {
    SentUnit unit;
    ASSERT_EQ(unit.write(0x1A04, 1, std::int64_t{index} << 16 | 0x20), 0U);
    EXPECT_EQ(unit.shown(index, 3000), 0x0C800000);
    EXPECT_EQ(unit.parameter(2, 8863, unit.unit_process_data.places(1).sent().find(index)->first), 0x40000000);
    EXPECT_EQ(unit.shown(index, -1500), -0x06400000);
    EXPECT_NEAR(static_cast<double>(unit.shown(index, 1)), 69905.07, 1.0);
    EXPECT_NEAR(static_cast<double>(unit.shown(index, 6000)), 0x19000000, 1.0) << "200 %";
    EXPECT_NEAR(static_cast<double>(unit.shown(index, 20000)), 0x19000000, 1.0) << "saturated";
    EXPECT_EQ(unit.shown(index, -20000), -0x19000000) << "saturated";
    ASSERT_EQ(unit.write(0x6094, 1, 4194304), 0U);
    ASSERT_EQ(unit.write(0x6094, 2, 60), 0U);
    EXPECT_EQ(unit.shown(index, 2500), 2500) << "rpm by the factor";
  }
}

TEST(SentVelocity, SaturatesAtTheEndsOfTheObject) {
  SentUnit unit{200000.0};
  ASSERT_EQ(unit.write(0x1A04, 1, 0x606C0020), 0U);
  EXPECT_EQ(unit.shown(0x606C, 40000), 0x7FFFFFFF);
  EXPECT_EQ(unit.shown(0x606C, -40000), -0x80000000LL);
}

TEST(SentRpm, IsRpmAndSaturates) {
  for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x6043, 0x6044}) {
    SentUnit unit;
    ASSERT_EQ(unit.write(0x1A04, 1, std::int64_t{index} << 16 | 0x10), 0U);
    for (const int rpm : {0, 1, 100, 1500, -3000, 5999})
      EXPECT_NEAR(static_cast<double>(unit.shown(index, rpm)), rpm, 0.5) << rpm;
    EXPECT_EQ(unit.shown(index, -20000), -6000);
    ASSERT_TRUE(unit.set_parameter(2, 2000, 0, 200000.0));
    EXPECT_EQ(unit.shown(index, 100000), 32767);
    EXPECT_EQ(unit.shown(index, -100000), -32768);
  }
}

TEST(SentTorque, IsPerMilleOfTheRatedTorqueAndSaturates) {
  for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x6074, 0x6077}) {
    ProcessDataUnit unit{1};
    unit.start();
    ASSERT_EQ(unit.write(0x1A04, 1, std::int64_t{index} << 16 | 0x10), 0U);
    unit.exchange();
    const std::size_t place = unit.unit_process_data.places(1).sent().find(index)->first;
    const double rated = unit.parameter(2, 333);
    ASSERT_TRUE(unit.set_parameter(2, 8851, place, own(1520)));
    for (const auto& [share, reference, per_mille, word] :
         {std::tuple{0.5, 1.0, 500, 0x2000}, std::tuple{1.0, 1.0, 1000, 0x4000},
          std::tuple{3.0, 1.0, 2000, 0x7FFF}, std::tuple{3.0, 4.0, 3000, 0x3000},
          std::tuple{0.25, 0.5, 250, 0x2000}, std::tuple{3.0, 0.5, 1000, 0x7FFF}}) {
      ASSERT_TRUE(unit.set_parameter(2, 2003, 0, reference * rated));
      ASSERT_TRUE(unit.set_parameter(2, 1520, 0, share * rated));
      EXPECT_NEAR(static_cast<double>(unit.read(index)), per_mille, 1.0) << share << " of " << reference;
      EXPECT_NEAR(unit.parameter(2, 8853, place), word, 1.0) << share << " of " << reference;
    }
  }
}

}  // namespace
}  // namespace device
