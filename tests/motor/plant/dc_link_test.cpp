#include "motor/plant/dc_link.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr double kPeriod = 125e-6;
constexpr double kUnloaded = 540.0;  // V, from 400 V

/// Draws @p power (W) for @p duration (s) in control periods.
void draw(DcLink& link, double power, double duration) {
  const auto steps = static_cast<int>(std::lround(duration / kPeriod));
  for (int i = 0; i < steps; ++i) link.step(kPeriod, power * kPeriod);
}

/// What came in less what went out (J); 0 if nothing is lost. @p stored_before is what was there at the start.
double imbalance(const DcLink& link, double stored_before) {
  const SupplyEnergies& e = link.energies();
  return e.from_line + e.missing - e.to_line - e.infeed_losses - e.chopper - e.axes -
         (link.stored() - stored_before);
}

TEST(DcLink, IsChargedFromTheStartToThePeakOfItsInfeed) {
  EXPECT_NEAR(DcLink{SupplyData{}}.voltage(), kUnloaded, 1e-9);
  EXPECT_NEAR(DcLink{{.infeed = Infeed::Regenerative}}.voltage(), kUnloaded, 1e-9);
  EXPECT_NEAR(DcLink{{.infeed = Infeed::Active}}.voltage(), 600.0, 1e-9);
}

TEST(DcLink, SagsUnderLoadAsASourceBehindItsResistanceDoes) {
  DcLink link{SupplyData{}};

  draw(link, 10e3, 0.1);

  const double half = 0.5 * kUnloaded;
  EXPECT_NEAR(link.voltage(), half + std::sqrt(half * half - 0.3 * 10e3), 0.1);
}

TEST(DcLink, OfADiodeInfeedKeepsWhatIsFedBack) {
  DcLink link{{.chopper_resistance = 0.0}};

  draw(link, -500.0, 0.1);
  draw(link, 0.0, 1.0);

  EXPECT_NEAR(link.voltage(), std::sqrt(kUnloaded * kUnloaded + 2.0 * 50.0 / 1.175e-3), 1e-6);
  EXPECT_EQ(link.energies().to_line, 0.0);
}

TEST(DcLink, OfARegenerativeInfeedFeedsBackToTheLine) {
  DcLink link{{.infeed = Infeed::Regenerative}};

  draw(link, -10e3, 0.5);

  EXPECT_GT(link.energies().to_line, 0.98 * 5000.0);
  EXPECT_LT(link.energies().to_line, 5000.0);
  EXPECT_LT(link.voltage(), kUnloaded + 7.0);
}

TEST(DcLink, RisesWhenMoreIsFedBackThanTheInfeedCarries) {
  DcLink link{{.infeed = Infeed::Active, .rated_power = 5e3, .chopper_resistance = 0.0}};

  draw(link, -8e3, 0.02);

  // 3 kW stay in the capacitors once the infeed is at its limit.
  EXPECT_NEAR(link.voltage(), std::sqrt(600.0 * 600.0 + 2.0 * 60.0 / 1.175e-3), 1.0);
}

TEST(DcLink, OfAnActiveInfeedHoldsItsVoltageInBothDirections) {
  DcLink link{{.infeed = Infeed::Active}};

  draw(link, 10e3, 0.2);
  EXPECT_NEAR(link.voltage(), 600.0, 6.0);
  draw(link, -10e3, 0.2);

  EXPECT_NEAR(link.voltage(), 600.0, 6.0);
}

TEST(DcLink, IsHeldByTheChopperBetweenItsThresholds) {
  DcLink link{SupplyData{}};
  double highest = 0.0;
  double lowest = 1e9;

  draw(link, -10e3, 0.2);
  for (int i = 0; i < 8000; ++i) {
    link.step(kPeriod, -10e3 * kPeriod);
    highest = std::max(highest, link.voltage());
    lowest = std::min(lowest, link.voltage());
  }

  EXPECT_LE(highest, 774.0 + 1e-9);
  EXPECT_GE(lowest, 759.0 - 1e-9);
  EXPECT_NEAR(link.energies().chopper, 12e3 - (link.stored() - DcLink{SupplyData{}}.stored()), 1e-6);
}

TEST(DcLink, RisesAgainstAChopperThatIsTooWeak) {
  DcLink link{{.chopper_resistance = 100.0}};

  draw(link, -10e3, 0.5);

  EXPECT_TRUE(link.chopper_on());
  EXPECT_NEAR(link.voltage(), std::sqrt(10e3 * 100.0), 1.0);
}

TEST(DcLink, HoldsAtZeroWhenTheLineIsGoneAndTheAxesStillAsk) {
  DcLink link{SupplyData{}};
  const double stored = link.stored();
  link.set_line_voltage(0.0);

  draw(link, 10e3, 0.1);

  EXPECT_EQ(link.voltage(), 0.0);
  EXPECT_NEAR(link.energies().missing, 1000.0 - stored, 1e-9);
  EXPECT_NEAR(imbalance(link, stored), 0.0, 1e-9);
}

TEST(DcLink, IsChargedAgainWhenTheLineIsBack) {
  DcLink link{SupplyData{}};
  link.set_line_voltage(0.0);
  draw(link, 10e3, 0.1);

  link.set_line_voltage(400.0);
  draw(link, 0.0, 0.1);

  EXPECT_NEAR(link.voltage(), kUnloaded, 1e-9);
}

TEST(DcLink, KeepsItsVoltageWithoutLineAndLoad) {
  DcLink link{SupplyData{}};
  link.set_line_voltage(0.0);

  link.step(3600.0, 0.0);

  EXPECT_NEAR(link.voltage(), kUnloaded, 1e-9);
  EXPECT_TRUE(link.settled());
}

TEST(DcLink, GoesTheSameWayInOneStepAsInMany) {
  for (const Infeed infeed : {Infeed::Diode, Infeed::Regenerative, Infeed::Active}) {
    for (const double power : {20e3, 0.0, -15e3, -40e3}) {
      const SupplyData data{.infeed = infeed, .rated_power = 12e3};
      DcLink once{data};
      DcLink often{data};

      once.step(0.02, power * 0.02);
      draw(often, power, 0.02);

      EXPECT_NEAR(once.voltage(), often.voltage(), 1e-6) << power;
      EXPECT_NEAR(once.energies().chopper, often.energies().chopper, 1e-6) << power;
      EXPECT_NEAR(once.energies().from_line - once.energies().to_line - once.energies().infeed_losses,
                  often.energies().from_line - often.energies().to_line - often.energies().infeed_losses, 1e-6);
    }
  }
}

TEST(DcLink, LosesNoEnergyUnderAnyLoadWhateverTheLineDoes) {
  const unsigned seed = 20261121;
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> power{-60e3, 60e3};
  std::uniform_real_distribution<double> line{0.0, 480.0};
  for (const Infeed infeed : {Infeed::Diode, Infeed::Regenerative, Infeed::Active}) {
    for (const double capacitance : {50e-6, 1.175e-3, 20e-3}) {
      DcLink link{{.infeed = infeed, .capacitance = capacitance}};
      const double stored = link.stored();
      for (int i = 0; i < 2000; ++i) {
        if (i % 50 == 0) link.set_line_voltage(i % 200 == 0 ? 0.0 : line(random));
        link.step(i % 7 == 0 ? 4e-3 : kPeriod, power(random) * (i % 3 == 0 ? kPeriod : 0.0));
        ASSERT_TRUE(std::isfinite(link.voltage()) && link.voltage() >= 0.0);
      }
      const SupplyEnergies& e = link.energies();
      EXPECT_NEAR(imbalance(link, stored), 0.0, 1e-9 * (e.from_line + e.to_line + e.chopper + 1.0));
      for (const double energy : {e.from_line, e.to_line, e.infeed_losses, e.chopper, e.missing})
        EXPECT_GE(energy, 0.0);
    }
  }
}

TEST(DcLink, IsSettledOnlyWhenNothingFlows) {
  DcLink link{SupplyData{}};
  EXPECT_TRUE(link.settled());

  draw(link, 10e3, 0.01);
  EXPECT_FALSE(link.settled());
  draw(link, 0.0, 0.1);

  EXPECT_TRUE(link.settled());
}

TEST(DcLink, OnALineAboveItsChopperBurnsAndLosesNoEnergy) {
  DcLink link{{.line_voltage = 600.0}};
  const double stored = link.stored();
  EXPECT_TRUE(link.chopper_on());

  draw(link, 1e3, 0.1);

  EXPECT_GT(link.energies().chopper, 0.1 * 774.0 * 774.0 / 20.0);
  EXPECT_NEAR(imbalance(link, stored), 0.0, 1e-6);
}

TEST(DcLink, CanBeStartedFromAnyVoltage) {
  DcLink link{SupplyData{}};

  link.start(800.0);

  EXPECT_NEAR(link.voltage(), 800.0, 1e-9);
  EXPECT_TRUE(link.chopper_on());
  EXPECT_NEAR(link.chopper_power(), 32e3, 1e-6);
}

}  // namespace
}  // namespace motor
