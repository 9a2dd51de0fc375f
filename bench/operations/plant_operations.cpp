#include <cmath>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "motor/data/control_period.hpp"
#include "motor/plant/plant.hpp"

namespace bench {
namespace {

/// A plant that turns at @p Speed on a voltage vector which turns with it.
class TurningPlant {
 public:
  TurningPlant(const motor::MachineData& machine, const motor::Load& load, motor::SpaceVector voltage)
      : plant_{machine, load}, voltage_{voltage}, turn_{turn(machine)} {
    plant_.set_brake(false);
    plant_.set_speed(kSpeed);
    for (int i = 0; i < kRunUp; ++i) step();
    check(std::abs(plant_.state().speed - kSpeed) < 0.5 * kSpeed, "speed of a plant");
  }
  void step() {
    voltage_ = voltage_ * turn_;
    plant_.step(voltage_);
  }

 private:
  static constexpr double kSpeed = 150.0;  // rad/s
  static constexpr int kRunUp = 1000;

  static motor::SpaceVector turn(const motor::MachineData& machine) {
    const double angle = machine.pole_pairs * kSpeed * motor::kControlPeriod;
    return {std::cos(angle), std::sin(angle)};
  }

  motor::Plant plant_;
  motor::SpaceVector voltage_;
  motor::SpaceVector turn_;
};

struct Servo : TurningPlant {
  Servo() : TurningPlant{{}, {.inertia = 0.1}, {0.0, 106.0}} {}
};

struct ServoWithTwoMasses : TurningPlant {
  ServoWithTwoMasses()
      : TurningPlant{{}, {.inertia = 0.1, .coupling = {.stiffness = 1000.0, .damping = 0.1}}, {0.0, 106.0}} {}
};

struct ServoWithFan : TurningPlant {
  ServoWithFan() : TurningPlant{{}, {.inertia = 0.1, .fan_coefficient = 1e-5}, {0.0, 106.0}} {}
};

struct Induction : TurningPlant {
  Induction()
      : TurningPlant{{.type = motor::MachineType::Induction, .pole_pairs = 2, .stator_resistance = 2.14},
                     {.inertia = 0.1},
                     {310.0, 0.0}} {}
};

}  // namespace

std::vector<OperationRow> plant_operations() {
  return {
      {"plant/servo", "125 us of a synchronous machine and one mass", make<Servo>},
      {"plant/servo-fan", "the same with a load that depends on the speed", make<ServoWithFan>},
      {"plant/servo-two-masses", "the same with an elastic coupling", make<ServoWithTwoMasses>},
      {"plant/induction", "125 us of an induction machine and one mass", make<Induction>},
  };
}

}  // namespace bench
