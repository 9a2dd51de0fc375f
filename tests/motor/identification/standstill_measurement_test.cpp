#include "motor/identification/standstill_measurement.hpp"

#include <gtest/gtest.h>

#include "tests/motor/identification/random_plants.hpp"

namespace motor {
namespace {

TEST(RandomPlants, AreMadeOfAllDeliveredMotors) {
  EXPECT_EQ(identification::presets().size(), 7U);
  std::mt19937_64 random{identification::plant_seed()};
  const PlantDeviation one = identification::random_deviation(random);
  EXPECT_NE(one, identification::random_deviation(random));
}

}  // namespace
}  // namespace motor
