// csp against the reference solutions k10 (set-points missing) and k11 (set-points sooner than 60C2h says).
#include <algorithm>
#include <cmath>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/position_rig.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace cia402 {
namespace {

constexpr double kUnit = 1.0;

TimeNs milliseconds(double count) {
  return std::chrono::milliseconds{std::lround(count)};
}

class ReferenceMotion {
 public:
  explicit ReferenceMotion(std::string_view name) : file_{name}, ours_{file_.table.names()} {
    const nlohmann::json& parameters = file_.about.at("parameters");
    rig_.settings.period = milliseconds(file_.number("/parameters/60C2h_ms"));
    rig_.settings.missed_set_points = 0;
    if (parameters.at("6085h").is_number()) rig_.settings.quick_stop_deceleration = parameters.at("6085h");
  }

  void run(bool is_supervised) {
    rig_.settings.is_supervised = is_supervised;
    for (const double time : file_.table.abscissa()) {
      const TimeNs now = milliseconds(1e3 * time);
      give_set_points(now);
      rig_.timeline.run_to(now);
      const Motion motion = rig_.mode.demand().motion;
      ours_.append({time, motion.position, motion.velocity});
    }
  }

  void expect_agreement() const {
    reference::expect_agreement(file_, ours_, reference::Band::Target);
    const std::vector<double>& expected = file_.table.column("pos");
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(ours_.column("pos")[i], expected[i], kUnit) << file_.table.abscissa()[i];
    EXPECT_NEAR(ours_.column("pos").back(), file_.number("/events/end_pos"), 1e-9);
    EXPECT_EQ(ours_.column("vel").back(), 0.0);
  }

 private:
  /// Those that arrive until @p now, this instant included.
  void give_set_points(TimeNs now) {
    const nlohmann::json& stimulus = file_.about.at("stimulus");
    const std::vector<std::size_t> missed = stimulus.at("missed k");
    const nlohmann::json& values = stimulus.at("setpoints");
    const double period = stimulus.at("period_ms");
    for (; next_ < values.size(); ++next_) {
      const TimeNs time = milliseconds(period * static_cast<double>(next_));
      if (time > now) return;
      if (std::find(missed.begin(), missed.end(), next_) == missed.end()) rig_.set_point(values[next_], time);
    }
  }

  reference::File file_;
  reference::Table ours_;
  PositionRig rig_;
  std::size_t next_ = 0;
};

TEST(CyclicPositionReference, ExtrapolatesOneSetPointAndBrakesWithoutTheSecond) {
  ReferenceMotion motion{"k10_csp_missed"};
  motion.run(true);
  motion.expect_agreement();
}

TEST(CyclicPositionReference, StartsTheLineAnewWithEverySetPoint) {
  ReferenceMotion motion{"k11_csp_mismatch"};
  motion.run(false);
  motion.expect_agreement();
}

}  // namespace
}  // namespace cia402
