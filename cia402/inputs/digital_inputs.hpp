#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cia402/inputs/input_event.hpp"
#include "cia402/inputs/travel_switches.hpp"

namespace cia402 {

/// What motor and load have done in a cycle, both on a straight line.
struct CycleMotion {
  std::int64_t motor_from = 0;  ///< increments of 608Fh since power-on
  std::int64_t motor_to = 0;    ///< likewise
  double load_from = 0.0;       ///< load revolutions from the place at power-on
  double load_to = 0.0;         ///< likewise
  double fraction_from = 0.0;   ///< of an increment, above motor_from
  double fraction_to = 0.0;     ///< above motor_to

  /// Where the motor was at begin and end (increments).
  double begin() const noexcept { return static_cast<double>(motor_from) + fraction_from; }
  double end() const noexcept { return static_cast<double>(motor_to) + fraction_to; }
};

/// Where the position value (6064h) is 0, in increments of the motor since power-on.
struct ZeroPlace {
  double position = 0.0;
  double period = 0.0;  ///< it is 0 again after so many (modulus of 607Bh), 0: nowhere else
};

/// Digital inputs and pulses of an axis in the cycle that has passed.
class DigitalInputs {
 public:
  /// What a cycle can have: every edge of every switch, and of each kind of pulse those at so many places, the one
  /// behind the begin among them.
  static constexpr std::size_t kMostPulses = 8;
  static constexpr std::size_t kMostEvents = 2 * TravelSwitches::kSignals.size() + 2 * kMostPulses;

  /// At power-on. An index comes at each multiple of @p per_revolution (608Fh, positive).
  DigitalInputs(const TravelSwitches& switches, std::uint32_t per_revolution) noexcept;

  /// A cycle has passed. @p zero is what held in it, if pulses of it are of interest.
  void pass(const CycleMotion& motion, const std::optional<ZeroPlace>& zero = std::nullopt) noexcept;

  /// What has happened in the cycle, by instants; where a switch and a pulse are at one place the switch is first.
  std::span<const InputEvent> events() const noexcept { return {events_.data(), count_}; }
  /// At the end of the cycle.
  const InputLevels& levels() const noexcept { return levels_; }
  const CycleMotion& motion() const noexcept { return motion_; }

 private:
  void look_at(Signal signal, const TravelSwitch& row) noexcept;
  void look_at_place(Signal signal, double place, Edge upward) noexcept;
  void look_for_pulses(Signal signal, const ZeroPlace& place) noexcept;
  void add(const InputEvent& event, double same_instant) noexcept;

  TravelSwitches switches_;
  double per_revolution_;
  CycleMotion motion_{};
  InputLevels levels_{};
  std::array<InputEvent, kMostEvents> events_{};
  std::size_t count_ = 0;
};

}  // namespace cia402
