#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/inputs/digital_inputs.hpp"
#include "cia402/modes/homing/homing_search.hpp"
#include "cia402/modes/homing/velocity_ramp.hpp"

namespace cia402 {

/// Objects that a homing takes when it starts.
struct HomingSettings {
  std::int8_t method = 0;     ///< 6098h, 0: none
  double switch_speed = 0.0;  ///< 6099h:1, positive (position units/s)
  double zero_speed = 0.0;    ///< 6099h:2, positive (position units/s)
  double acceleration = 1.0;  ///< 609Ah, also of its braking, positive (position units/s²)
  double deceleration = 1.0;  ///< 6084h, of a motion that the mode is entered in, positive (position units/s²)
  double offset = 0.0;        ///< 607Ch: from zero back to home (position units)
  double longest_search = 200.0;  ///< without an event, positive (load revolutions)
};

/// Where home is: the position value (6064h) is 0 at home + offset.
struct Home {
  double position = 0.0;  ///< exact (increments of the motor since power-on)
  double offset = 0.0;    ///< 607Ch as it was at the start (position units)
};

/// Why a homing has failed.
enum class HomingError : std::uint8_t {
  None,
  Method,       ///< 6098h is 0 or reserved
  LimitSwitch,  ///< one that the method does not use, or one more than it uses
  NoEvent,      ///< nothing came in the longest search
  Fault,        ///< a fault has ended it
};

/// Why the mode is led no longer.
enum class HomingExit : std::uint8_t { Disabled, Fault, OtherMode };

/// Homing mode (hm; CiA 402-2). Positive is where the increments of the motor rise. Software limits and the range
/// of 607Bh do not count in it.
class Homing {
 public:
  /// In another mode before: 6041h tells whether there is a home. Else it tells what became of the last homing.
  void enter(const Motion& present) noexcept;
  /// A halt is released.
  void resume(const Motion& present) noexcept;
  void leave(HomingExit exit) noexcept;
  /// Bit 4 starts and interrupts, bit 8 halts. A start counts from this very update on.
  void controlword(std::uint16_t word, std::uint16_t former, const HomingSettings& settings) noexcept;
  /// @p inputs are those of the cycle that has passed, the demand is that of the end of the next one.
  Demand cycle(const HomingSettings& settings, const Limits& limits, const DigitalInputs& inputs) noexcept;
  /// Bits 10, 12, 13 of 6041h. @p is_stopping: a halt or another stop from outside still brakes.
  ModeBits bits(bool is_stopping = false) const noexcept;

  /// The home that the last cycle has come past, once. Whoever takes it moves zero and calls shift().
  std::optional<Home> take_home() noexcept { return std::exchange(home_, std::nullopt); }
  /// The coordinates have moved: every position is higher by @p by (position units).
  void shift(double by) noexcept { ramp_.shift(by); }

  /// Whether there is a home since power-on (6041h bit 15).
  bool is_homed() const noexcept { return is_homed_; }
  /// An encoder that lost its position, or an absolute one that has a home already.
  void set_homed(bool is_homed) noexcept { is_homed_ = is_homed; }
  /// From the start to the event.
  bool is_running() const noexcept { return state_ == State::Starting || state_ == State::Searching; }
  /// Of the last homing, until the next one starts.
  HomingError error() const noexcept { return error_; }

 private:
  enum class State : std::uint8_t {
    Ready,  ///< nothing has been asked for since another mode was left
    Starting,
    Searching,
    Interrupted,
    Attained,
    Failed,
  };

  void start(const HomingSettings& settings) noexcept;
  void begin(const DigitalInputs& inputs) noexcept;
  void follow(const DigitalInputs& inputs) noexcept;
  void attain(double position) noexcept;
  void fail(HomingError error) noexcept;
  void interrupt() noexcept;
  void look_at_search() noexcept;
  double wanted_velocity() const noexcept;

  State state_ = State::Ready;
  HomingError error_ = HomingError::None;
  bool is_homed_ = false;
  bool is_led_outside_ = true;  // a halt or another stop leads the motion, or nothing does
  bool has_started_ = false;    // since it was entered
  HomingSettings settings_{};   // of the last start
  const HomingMethod* method_ = nullptr;
  HomingSearch search_{};
  double last_event_ = 0.0;  // where the load was then (load revolutions)
  VelocityRamp ramp_{};
  std::optional<Home> home_{};
};

}  // namespace cia402
