#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

constexpr double kSample = 5e-4;  // s
constexpr double kFrom = 500.0, kStep = 50.0;

/// A servo axis whose control believes that the motor turns alone, though it moves five times its own inertia.
struct HeavyAxis : TestAxis {
  HeavyAxis() : TestAxis{{.load = {.inertia = 4.0 * motor::MachineData{}.inertia}}} {
    write(342, 1.0);
    write(10, 3.0);
    write(340, 4.0);
    write(10, 0.0);
    write(1120, 0.0);
  }
  void write(std::uint16_t parameter, double value) { EXPECT_TRUE(axis.write(parameter, value)) << parameter; }
  /// p1960 at the next ON.
  void measure() {
    write(1960, 1.0);
    enable();
    run_until([](const Axis& a) { return a.read(1960).value() == 0.0; }, 60.0);
    send(0x0000);
  }
  /// The speed (rpm) every kSample from a step of the setpoint on, which begins at a steady speed.
  std::vector<double> step() {
    enable(kFrom);
    run(1.0);
    setpoints.speed = (kFrom + kStep) * kRpm;
    std::vector<double> speeds;
    while (speeds.size() < 300) {
      speeds.push_back(rpm());
      axis.cycle(setpoints, kSample);
    }
    send(0x0000);
    run(5.0);
    return speeds;
  }
};

double overshoot(const std::vector<double>& speeds) {
  return (*std::ranges::max_element(speeds) - kFrom - kStep) / kStep;
}
/// Until nine tenths of the step (s).
double rise_time(const std::vector<double>& speeds) {
  const auto there = std::ranges::find_if(speeds, [](double rpm) { return rpm >= kFrom + 0.9 * kStep; });
  return kSample * static_cast<double>(there - speeds.begin());
}

/// With AXISD_PHYSICS_OUT set to a folder, for the picture in docs/how-to/commissioning.md.
void record(const std::vector<double>& before, const std::vector<double>& after) {
  const char* const folder = std::getenv("AXISD_PHYSICS_OUT");
  if (folder == nullptr) return;
  std::filesystem::create_directories(folder);
  std::ofstream file{std::filesystem::path{folder} / "speed_step.csv"};
  file << "t_s,before,after\n";
  for (std::size_t i = 0; i < before.size(); ++i)
    file << kSample * static_cast<double>(i) << ',' << before[i] << ',' << after[i] << '\n';
}

TEST(SpeedStep, IsAsFastAndCalmAsTheMotorAloneOnceTheInertiaIsMeasured) {
  HeavyAxis axis;
  const std::vector<double> before = axis.step();

  axis.measure();

  EXPECT_NEAR(axis.axis.read(342).value(), 5.0, 0.1);
  const std::vector<double> after = axis.step();
  EXPECT_LT(rise_time(after), 0.5 * rise_time(before));
  EXPECT_LT(overshoot(after), 0.5 * overshoot(before));
  EXPECT_LT(overshoot(after), 0.1);
  record(before, after);
}

}  // namespace
}  // namespace drive
