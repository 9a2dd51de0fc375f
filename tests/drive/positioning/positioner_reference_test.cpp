// Motions of a whole unit against the reference solutions: r2665 every millisecond.
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace drive {
namespace {

/// A unit that gets orders at whole milliseconds and is held against a reference solution.
class ReferenceRun {
 public:
  explicit ReferenceRun(std::string_view name) : file{name} {
    for (const std::uint16_t number : std::initializer_list<std::uint16_t>{2571, 2572, 2573})
      unit.set(number, file.number("/parameters/p" + std::to_string(number)));
    unit.set(2544, 0.0);  // without a window the setpoint alone decides
    unit.enable();
    unit.set_reference();
    unit.run(5);
  }
  double stimulus(const char* name) const { return file.about.at("stimulus").at(name).get<double>(); }
  /// At @p time (s) do @p order.
  void at(double time, std::function<void()> order) {
    orders_.emplace_back(std::lround(time * 1000.0), std::move(order));
  }
  /// To the last row; the position has to agree within the band, and the end exactly.
  void expect_agreement() {
    const std::vector<double>& times = file.table.abscissa();
    const std::vector<double>& positions = file.table.column("pos");
    const double range = file.number("/ranges/pos/1") - file.number("/ranges/pos/0");
    const double band = file.number("/bands_must/max_pct") / 100.0 * range;
    std::size_t row = 0;
    for (std::int64_t now = 0; row < times.size(); ++now) {
      if (std::lround(times[row] * 1000.0) == now) {
        ASSERT_NEAR(unit.read(2665), positions[row], band) << "at " << times[row] << " s";
        ++row;
      }
      for (const auto& [instant, order] : orders_)
        if (instant == now) order();
      unit.run(1);
      unit.set(2650, 0.0);
      unit.set(2631, 0.0);
    }
    EXPECT_EQ(unit.read(2665), positions.back());
    EXPECT_TRUE(unit.bit(2683, 3));
    EXPECT_TRUE(unit.messages().empty());
  }

  reference::File file;
  PositioningUnit unit;

 private:
  std::vector<std::pair<std::int64_t, std::function<void()>>> orders_;
};

/// MDI setpoints that are taken over by edges, in motion too.
void follow_setpoints(std::string_view name) {
  ReferenceRun run{name};
  PositioningUnit& unit = run.unit;
  unit.set(2647, 1.0);
  unit.set(2648, 1.0);
  for (const nlohmann::json& setpoint : run.file.about.at("stimulus"))
    run.at(setpoint.at("t_s").get<double>(), [&unit, &setpoint] {
      unit.set(2690, setpoint.at("p2642").get<double>());
      unit.set(2691, setpoint.at("p2643").get<double>());
      unit.set(2693, setpoint.value("p2645", 100.0));
      unit.set(2650, 1.0);
    });
  run.expect_agreement();
}

TEST(PositionerReference, MdiTakesNewTargetsInMotion) {
  follow_setpoints("k5_mdi_retarget");
}

TEST(PositionerReference, MdiReversesToATargetBehind) {
  follow_setpoints("k6_mdi_reverse");
}

TEST(PositionerReference, ABlockIsStoppedRejectedAndStartedAgain) {
  ReferenceRun run{"k8_stop_reject"};
  PositioningUnit& unit = run.unit;
  unit.block(0, {.number = 1,
                 .position = run.stimulus("target"),
                 .velocity = run.file.number("/parameters/p2618"),
                 .acceleration = run.file.number("/parameters/p2619"),
                 .deceleration = run.file.number("/parameters/p2620")});
  unit.set(2625, 1.0);
  const auto start = [&] {
    unit.set(2641, 1.0);
    unit.set(2631, 1.0);
  };
  run.at(run.stimulus("start"), start);
  run.at(run.stimulus("p2640_0"), [&] { unit.set(2640, 0.0); });
  run.at(run.stimulus("p2640_1"), [&] { unit.set(2640, 1.0); });
  run.at(run.stimulus("p2641_0"), [&] { unit.set(2641, 0.0); });
  run.at(run.stimulus("restart"), start);
  run.expect_agreement();
}

TEST(PositionerReference, FlyingBlocksChangeAtTheirBrakingPoints) {
  ReferenceRun run{"k9_flying"};
  PositioningUnit& unit = run.unit;
  const nlohmann::json& blocks = run.file.about.at("stimulus").at("blocks");
  constexpr int kFlying = 0x20;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    unit.block(i, {.number = static_cast<int>(i) + 1,
                   .position = blocks[i].at("p2617").get<double>(),
                   .velocity = blocks[i].at("p2618").get<double>(),
                   .mode = i + 1 < blocks.size() ? kFlying : 0,
                   .acceleration = blocks[i].at("p2619").get<double>(),
                   .deceleration = blocks[i].at("p2620").get<double>()});
  unit.set(2625, 1.0);
  run.at(0.0, [&] { unit.set(2631, 1.0); });
  run.expect_agreement();
}

}  // namespace
}  // namespace drive
