#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "drive/positioning/profile/motion_generator.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace drive {

/// LU/s of a parameter in 1000 LU/min, LU/s² of one in 1000 LU/s².
inline constexpr double kVelocityUnit = 1000.0 / 60.0;
inline constexpr double kAccelerationUnit = 1000.0;

/// A motion that gets orders at whole milliseconds and is written down where a reference has rows.
class RecordedMotion {
 public:
  explicit RecordedMotion(std::string_view name) : file{name}, ours{known_columns(file)} {}

  /// A parameter of the reference in SI.
  double velocity(const std::string& name) const { return parameter(name) * kVelocityUnit; }
  double acceleration(const std::string& name) const { return parameter(name) * kAccelerationUnit; }
  double parameter(const std::string& name) const { return file.number("/parameters/" + name); }

  /// At @p time (s, whole milliseconds) do @p order.
  void at(double time, std::function<void()> order) {
    orders_.emplace_back(std::lround(time / kMotionCycle), std::move(order));
  }
  /// To the last row of the reference; @p cycle goes on by one cycle.
  void run(const std::function<void()>& cycle) {
    const std::vector<double>& times = file.table.abscissa();
    const std::int64_t end = std::lround(times.back() / kMotionCycle);
    std::size_t row = 0;
    for (std::int64_t now = 0; now <= end; ++now) {
      for (const auto& [instant, order] : orders_)
        if (instant == now) order();
      if (std::lround(times[row] / kMotionCycle) == now) append(times[row++]);
      cycle();
    }
  }
  void run() {
    run([this] { motion.advance(kMotionCycle); });
  }
  /// Holds what was written down against the target band, and its end against the end of the reference.
  void expect_agreement() const {
    reference::expect_agreement(file, ours, reference::Band::Target);
    EXPECT_NEAR(ours.column("pos").back(), file.table.column("pos").back(),
                file.number("/bands_target/end_pos_abs"));
    EXPECT_EQ(ours.column("vel").back(), 0.0);
    EXPECT_TRUE(motion.stands());
  }

  reference::File file;
  reference::Table ours;
  MotionGenerator motion{true};
  double turned = 0.0;  ///< by which the motion was shifted back (LU)

 private:
  static std::vector<std::string> known_columns(const reference::File& file) {
    std::vector<std::string> names;
    for (const std::string& name : file.table.names())
      if (name != "jerk") names.push_back(name);
    return names;
  }
  void append(double time) {
    std::vector<double> row;
    for (const std::string& name : ours.names()) row.push_back(value(name, time));
    ours.append(row);
  }
  double value(const std::string& name, double time) const {
    if (name == "t_s") return time;
    if (name == "pos") return motion.position() + turned;
    if (name == "pos_mod") return motion.position();
    return name == "vel" ? motion.velocity() : motion.acceleration();
  }

  std::vector<std::pair<std::int64_t, std::function<void()>>> orders_;
};

}  // namespace drive
