// Exact reference solutions: f1 of the profiles from rest to rest, k5 to k7 of set-points taken in motion and
// rotary axes.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cia402/motion/position_profile.hpp"
#include "tests/cia402/profile/positioned_axis.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace cia402 {
namespace {

constexpr double kVelocityUnit = 1000.0 / 60.0;
constexpr double kAccelerationUnit = 1000.0;

using reference::File;
using reference::Table;

void expect_same(const File& file, const Table& ours) {
  reference::expect_agreement(file, ours, reference::Band::Target);
  EXPECT_NEAR(ours.column("pos").back(), file.table.column("pos").back(),
              file.number("/bands_target/end_pos_abs"));
}

class RestToRest : public testing::TestWithParam<std::string_view> {};

TEST_P(RestToRest, IsThatOfItsReference) {
  const File file{GetParam()};
  const nlohmann::json& limits = file.about.at("limits_and_times");
  const double acceleration = limits.at("a").get<double>();
  PositionProfile profile;
  profile.place(0.0);
  profile.move_to(limits.at("s").get<double>(), {.velocity = limits.at("v").get<double>(),
                                                 .acceleration = acceleration,
                                                 .deceleration = limits.value("d", acceleration),
                                                 .jerk = limits.value("j", 0.0)});
  Table ours{{"t_s", "pos", "vel"}};
  double now = 0.0;
  for (const double time : file.table.abscissa()) {
    profile.advance(time - now);
    now = time;
    ours.append({time, profile.position(), profile.velocity()});
  }
  expect_same(file, ours);
  EXPECT_EQ(profile.position(), limits.at("s").get<double>());
  EXPECT_TRUE(profile.has_arrived());
}

INSTANTIATE_TEST_SUITE_P(F1, RestToRest,
                         testing::Values("f1_profile_0_trap", "f1_profile_1_trap", "f1_profile_2_jerk",
                                         "f1_profile_3_jerk", "f1_profile_4_jerk"));

/// An axis that is given set-points at whole milliseconds, and written down where a reference has rows.
struct RecordedAxis : PositionedAxis {
  explicit RecordedAxis(std::string_view name, double start = 0.0)
      : PositionedAxis{start}, file{name}, ours{{"t_s", "pos", "vel"}} {
    settings.acceleration = parameter("p2572") * kAccelerationUnit;
    settings.deceleration = parameter("p2573") * kAccelerationUnit;
  }
  double parameter(const std::string& number) const { return file.number("/parameters/" + number); }
  /// @p order is given the tasks whose time has come.
  template <class Order>
  void follow(const nlohmann::json& tasks, const Order& order) {
    const std::vector<double>& times = file.table.abscissa();
    std::size_t row = 0;
    for (std::int64_t now = 0; row < times.size(); ++now) {
      if (std::lround(times[row] / kCycle) == now) ours.append({times[row++], position(), velocity()});
      for (const nlohmann::json& task : tasks)
        if (std::lround(task.at("t_s").get<double>() / kCycle) == now) order(task);
      cycle();
    }
    expect_same(file, ours);
    EXPECT_TRUE(is_reached());
  }

  File file;
  Table ours;
};

void follow_set_points(std::string_view name) {
  RecordedAxis axis{name};
  const double deceleration = axis.settings.deceleration;
  axis.follow(axis.file.about.at("stimulus"), [&](const nlohmann::json& task) {
    axis.settings.velocity = task.at("p2643").get<double>() * kVelocityUnit;
    axis.settings.deceleration = deceleration * task.value("p2645", 100.0) / 100.0;
    axis.give(task.at("p2642").get<double>(), kImmediately);
  });
}

TEST(Retarget, InCruiseAndWhileBrakingIsThatOfItsReference) {
  follow_set_points("k5_mdi_retarget");
}

TEST(Retarget, WithLessDecelerationAndBackwardsIsThatOfItsReference) {
  follow_set_points("k6_mdi_reverse");
}

TEST(RotaryAxis, GoesEveryWayOfItsReference) {
  const File file{"k7_modulo"};
  RecordedAxis axis{"k7_modulo", file.number("/stimulus/start")};
  axis.settings.velocity = axis.parameter("p2643") * kVelocityUnit;
  axis.limits.range = Span{0.0, axis.parameter("p2576") - 1.0};
  axis.follow(axis.file.about.at("stimulus").at("tasks"), [&](const nlohmann::json& task) {
    const std::string way = task.at("way").get<std::string>();
    axis.settings.option_code = way == "negative" ? 1U << 6U : way == "positive" ? 2U << 6U : 3U << 6U;
    axis.give(task.at("p2642").get<double>());
    axis.write(kEnabled);
  });
  EXPECT_EQ(axis.position(), 190000.0 + 360000.0);
}

}  // namespace
}  // namespace cia402
