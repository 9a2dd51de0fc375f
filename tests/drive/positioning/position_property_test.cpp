// Random motions and inputs: the position is the rounded length of the counts and a whole number, whatever
// happens.
#include <random>

#include <gtest/gtest.h>

#include "tests/drive/positioning/sensed_axis.hpp"

namespace drive {
namespace {

__extension__ using Wide = __int128;

std::int64_t rounded_quotient(Wide dividend, Wide divisor) {
  const Wide twice = 2 * (dividend < 0 ? -dividend : dividend) + divisor;
  const Wide quotient = twice / (2 * divisor);
  return static_cast<std::int64_t>(dividend < 0 ? -quotient : quotient);
}

/// An axis and what its position should be.
class RandomAxis {
 public:
  RandomAxis(unsigned seed, std::int64_t modulo_range) : random_{seed}, range_{modulo_range} {
    ActualPosition::Settings& settings = axis_.position.settings;
    settings.gear_motor = pick(100, 2000);
    settings.gear_load = pick(0, 1) == 0 ? pick(1, 2000) : -pick(1, 2000);
    settings.units_per_load = pick(1, 100'000);
    axis_.slice.modulo_range = modulo_range;
  }

  void step() {
    const int chosen = pick(0, 9);
    ActualPosition::Inputs& inputs = axis_.position.inputs;
    if (chosen == 0) correct(pick(-1000, 1000));
    if (chosen == 1) set(pick(0, static_cast<int>(range_ > 0 ? range_ - 1 : 1'000'000)));
    inputs.correction[0] = pick(-500, 500);
    const bool edge = chosen == 2 && !inputs.correct[0];
    inputs.correct[0] = chosen == 2;
    if (edge) offset_ += static_cast<std::int64_t>(inputs.correction[0]);
    if (chosen == 3) inputs.offset[0] = pick(-1000, 1000);
    axis_.slice.setpoint.reset();
    if (range_ > 0 && chosen >= 6) axis_.slice.setpoint = pick(0, static_cast<int>(range_ - 1));
    axis_.turn(chosen == 5 ? pick(-10'000, 10'000) : pick(-300, 300));
    check();
  }

 private:
  int pick(int low, int high) { return std::uniform_int_distribution<int>{low, high}(random_); }

  void correct(int by) {
    axis_.position.correct(by);
    offset_ += by;
  }
  void set(int value) {
    const std::int64_t before = axis_.shown();
    ASSERT_TRUE(axis_.position.set_position(value));
    offset_ += value - before;
    EXPECT_EQ(axis_.shown(), value);
  }
  void check() const {
    const ActualPosition& position = axis_.position;
    const ActualPosition::Settings& settings = position.settings;
    const std::int64_t exact =
        rounded_quotient(Wide{axis_.slice.counts} * settings.units_per_load * settings.gear_load,
                         Wide{SensedAxis::kPerRevolution} * settings.gear_motor) +
        offset_ + static_cast<std::int64_t>(position.inputs.offset[0]);
    ASSERT_TRUE(position.position_valid());
    ASSERT_LE(std::abs(position.position() - static_cast<double>(position.shown())), 0.5 + 1e-6);
    if (range_ == 0) {
      ASSERT_EQ(position.shown(), exact);
    } else if (axis_.slice.setpoint) {
      ASSERT_EQ((position.shown() - exact) % range_, 0);
      ASSERT_LE(std::abs(position.position() - *axis_.slice.setpoint), static_cast<double>(range_) / 2.0 + 1e-6);
    } else {
      ASSERT_EQ(position.shown(), (exact % range_ + range_) % range_);
    }
  }

  SensedAxis axis_{};
  std::mt19937 random_;
  std::int64_t range_;       // LU, 0: no modulo axis
  std::int64_t offset_ = 0;  // LU, all that was set and corrected
};

class RandomPosition : public testing::TestWithParam<unsigned> {};

TEST_P(RandomPosition, IsWhatTheCountsAndTheCorrectionsMake) {
  for (const std::int64_t range : {std::int64_t{0}, std::int64_t{1}, std::int64_t{360}, std::int64_t{360'000}}) {
    RandomAxis axis{GetParam(), range};
    for (int i = 0; i < 500 && !testing::Test::HasFatalFailure(); ++i) axis.step();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPosition, testing::Range(1U, 41U));

}  // namespace
}  // namespace drive
