#pragma once

#include <utility>

namespace drive {

/// The jog bits of an axis with extended setpoint channel, and the setpoints that they choose (rad/s).
class Jog {
 public:
  struct Settings {
    using Block = Jog;

    double speed_1 = 0.0;  ///< p1058
    double speed_2 = 0.0;  ///< p1059
  };
  struct Inputs {
    using Block = Jog;

    bool jog_1 = false;  ///< p1055
    bool jog_2 = false;  ///< p1056

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// A cycle begins with the inputs as they are.
  void begin_cycle() noexcept { wanted_ = std::exchange(wants_, inputs.jog_1 || inputs.jog_2); }
  /// Power-off, or the function module is switched out: no input has come yet.
  void power_off() noexcept {
    inputs = {};
    wants_ = false;
  }

  /// Whether a bit is set, and was so in the cycle before.
  bool wants() const noexcept { return wants_; }
  bool wanted() const noexcept { return wanted_; }
  /// Whether both bits are set, which is no setpoint.
  bool has_both() const noexcept { return inputs.jog_1 && inputs.jog_2; }
  /// The one of the two setpoints whose bit is set; both at once are none.
  double setpoint() const noexcept {
    if (inputs.jog_1 == inputs.jog_2) return 0.0;
    return inputs.jog_1 ? settings.speed_1 : settings.speed_2;
  }

  Settings settings{};
  Inputs inputs{};

 private:
  bool wants_ = false;
  bool wanted_ = false;
};

}  // namespace drive
