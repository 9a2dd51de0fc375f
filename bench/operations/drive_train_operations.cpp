#include <algorithm>
#include <cmath>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "motor/drive_train.hpp"

namespace bench {
namespace {

/// An axis of motor/ that turns under half of its rated torque.
class LoadedTrain {
 public:
  LoadedTrain(const motor::MachineData& machine, motor::ControlMode mode)
      : train_{machine, {.inertia = machine.inertia}}, target_{0.5 * machine.rated_speed} {
    motor::ControlSettings settings = train_.settings();
    settings.mode = mode;
    train_.tune(settings);
    command_.limits = {machine.maximum_torque, -machine.maximum_torque};
    const double change = target_ / kRunUp;
    for (int i = 0; i < kMagnetising; ++i) step();
    for (int i = 0; i < 2 * kRunUp; ++i) {
      command_.speed_setpoint = std::min(target_, command_.speed_setpoint + change);
      step();
    }
    train_.set_load_torque(0.5 * machine.rated_torque);
    for (int i = 0; i < kRunUp; ++i) step();
    check(std::abs(train_.signals().true_speed - target_) < 0.05 * target_, "speed of a drive train");
  }
  void step() { drawn_ += train_.step(kDcVoltage, command_); }

 private:
  static constexpr double kDcVoltage = 540.0;  // V
  static constexpr int kMagnetising = 4000;    // steps
  static constexpr int kRunUp = 8000;          // steps

  motor::DriveTrain train_;
  motor::DriveCommand command_{.pulses_enabled = true};
  double target_;
  double drawn_ = 0.0;  // J
};

motor::MachineData induction_machine() {
  motor::MachineData machine;
  machine.type = motor::MachineType::Induction;
  machine.pole_pairs = 2;
  machine.rated_speed = 1455.0 * motor::kRpm;
  machine.rated_frequency = 50.0;
  machine.rated_torque = 14.4;
  machine.inertia = 0.014;
  machine.stator_resistance = 2.14;
  return machine;
}

struct Servo : LoadedTrain {
  Servo() : LoadedTrain{{}, motor::ControlMode::Encoder} {}
};
struct ServoWithoutEncoder : LoadedTrain {
  ServoWithoutEncoder() : LoadedTrain{{}, motor::ControlMode::Sensorless} {}
};
struct Induction : LoadedTrain {
  Induction() : LoadedTrain{induction_machine(), motor::ControlMode::Encoder} {}
};
struct InductionWithoutEncoder : LoadedTrain {
  InductionWithoutEncoder() : LoadedTrain{induction_machine(), motor::ControlMode::Sensorless} {}
};
struct InductionByFrequency : LoadedTrain {
  InductionByFrequency() : LoadedTrain{induction_machine(), motor::ControlMode::VoltageFrequency} {}
};

}  // namespace

std::vector<OperationRow> drive_train_operations() {
  return {
      {"train/servo", "125 us of a synchronous machine with all control loops", make<Servo>},
      {"train/servo-sensorless", "the same without encoder", make<ServoWithoutEncoder>},
      {"train/induction", "125 us of an induction machine with all control loops", make<Induction>},
      {"train/induction-sensorless", "the same without encoder", make<InductionWithoutEncoder>},
      {"train/induction-vf", "the same under V/f control", make<InductionByFrequency>},
  };
}

}  // namespace bench
