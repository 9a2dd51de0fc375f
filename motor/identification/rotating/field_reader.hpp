#pragma once

#include <cstdint>

#include "motor/control/control_settings.hpp"
#include "motor/control/observation.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// The integral of a quantity from the start of a block on: at its end, and the mean while it grew.
struct Growth {
  double total = 0.0;
  double mean = 0.0;
};

/// What a drive saw in some control periods, with vectors as means in the frame of its control.
struct FieldBlock {
  double duration = 0.0;  ///< (s)
  Growth angle{};         ///< of the shaft (rad)
  Growth impulse{};       ///< of the torque that the power balance gives without threshold voltage (N·m·s)
  Growth lost_impulse{};  ///< what each volt of threshold voltage takes from it (N·m·s/V)
  double control_impulse = 0.0;  ///< of the torque that the control believes in (N·m·s)
  double frequency = 0.0;        ///< of the frame (electrical rad/s)
  SpaceVector voltage{};         ///< that was asked for (V)
  SpaceVector current{};         ///< (A)
  SpaceVector current_slope{};   ///< (A/s)
  SpaceVector threshold{};       ///< what a volt of threshold voltage takes from the voltage (V/V)
  double resistance = 0.0;       ///< of the stator, as warm as it is (Ω)

  /// Of the shaft (rad/s).
  double speed() const noexcept { return angle.total / duration; }
};

/// Reads observations of a machine that turns: what happened between two readings of the currents, in blocks of
/// kPeriods. The torque is that of the power balance, which needs of the machine only its resistance,
///   T = p/w_s (3/2 u·i - 3/2 R i² - threshold voltage · sum of phase currents - change of the leakage field),
/// and holds where the field turns.
class FieldReader {
 public:
  static constexpr int kPeriods = 16;

  void start(const MachineData& machine, const ControlSettings& settings) noexcept;
  /// Takes in what was seen after a step. The block that ends with it, nullptr while there is none.
  const FieldBlock* take(const Observation& seen) noexcept;
  /// The angle of the shaft since the start (rad).
  double angle() const noexcept { return angle_; }

 private:
  /// A control period between two readings of the currents.
  struct Period {
    double angle = 0.0;
    SpaceVector current{};        // rotor frame
    SpaceVector current_slope{};  // rotor frame
    SpaceVector voltage{};
    SpaceVector threshold{};
  };

  SpaceVector direction_of(const Observation& seen) const noexcept;
  double angle_of(const Observation& seen) noexcept;
  Period between(const Observation& before, const Observation& now) const noexcept;
  void add(const Period& period, const Observation& before) noexcept;

  double resistance_ = 0.0;   // at kDataTemperature
  SpaceVector inductance_{};  // that stores energy as the current changes
  double pole_pairs_ = 1.0;
  double radians_per_count_ = 0.0;
  bool with_encoder_ = true;
  int seen_ = 0;  // observations, at most 2 are counted
  Observation last_{};
  SpaceVector direction_{1.0, 0.0};  // of the frame at the last reading
  std::int64_t counts_ = 0;          // at the last reading
  double angle_ = 0.0;
  double turned_ = 0.0;  // in the last period before the last reading (rad)
  int periods_ = 0;      // in the block
  FieldBlock open_{};
  FieldBlock block_{};
};

}  // namespace motor
