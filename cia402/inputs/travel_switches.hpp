#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "cia402/inputs/input_event.hpp"

namespace cia402 {

/// A switch beside the way of the load: on from a place to another one. A place belongs to what lies above it.
struct TravelSwitch {
  double from = 0.0;      ///< load revolutions from the place at power-on; may be infinite
  double to = 0.0;        ///< likewise, above from
  bool inverted = false;  ///< off there, and on elsewhere

  constexpr bool is_on_at(double place) const noexcept { return (from <= place && place < to) != inverted; }
};

/// The switches of an axis, at most one for each signal that has a level. A signal without switch is 0.
class TravelSwitches {
 public:
  static constexpr std::array kSignals{Signal::NegativeLimit, Signal::PositiveLimit, Signal::Home, Signal::Probe1,
                                       Signal::Probe2};

  /// The switch of @p signal, which is one of kSignals.
  constexpr const std::optional<TravelSwitch>& of(Signal signal) const noexcept {
    return switches_[static_cast<std::size_t>(signal)];
  }
  constexpr void set(Signal signal, const TravelSwitch& fitted) noexcept {
    switches_[static_cast<std::size_t>(signal)] = fitted;
  }

 private:
  std::array<std::optional<TravelSwitch>, kSignals.size()> switches_{};
};

}  // namespace cia402
