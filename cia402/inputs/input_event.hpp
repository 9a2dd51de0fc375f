#pragma once

#include <cstdint>

namespace cia402 {

/// What an axis can be told by: switches beside its way, in the order of their bits in InputLevels, and two
/// pulses.
enum class Signal : std::uint8_t {
  NegativeLimit,  ///< N
  PositiveLimit,  ///< P
  Home,           ///< H
  Probe1,
  Probe2,
  Index,         ///< pulse of the encoder, once in a revolution of the motor
  SoftwareZero,  ///< pulse where the position value (6064h) comes past 0
};

/// How a signal changes. A pulse has no length: it is a rising edge and a falling one at the same place.
enum class Edge : std::uint8_t { Rising, Falling, Pulse };

/// A change of a signal, exactly where and when it was.
struct InputEvent {
  Signal signal = Signal::Home;
  Edge edge = Edge::Rising;
  bool is_upward = true;  ///< met in positive direction
  double instant = 0.0;   ///< of the cycle, 0..1
  double position = 0.0;  ///< of the motor (increments of 608Fh since power-on)
};

/// Levels of the switches.
class InputLevels {
 public:
  constexpr bool at(Signal signal) const noexcept { return (bits_ & bit(signal)) != 0; }
  constexpr void set(Signal signal, bool level) noexcept {
    bits_ = static_cast<std::uint8_t>(level ? bits_ | bit(signal) : bits_ & ~bit(signal));
  }
  /// 60FDh: bits 0 N, 1 P, 2 H, 16 and 17 probes; there is no interlock (bit 3).
  constexpr std::uint32_t word() const noexcept { return (bits_ & 0x07U) | (bits_ & 0x18U) << 13U; }

  friend bool operator==(const InputLevels&, const InputLevels&) = default;

 private:
  static constexpr unsigned bit(Signal signal) noexcept { return 1U << static_cast<unsigned>(signal); }

  std::uint8_t bits_ = 0;
};

}  // namespace cia402
