#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "daemon/watch/unit_event.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace sim {

class SimulatedUnit;

/// The first thing that was not as it has to be.
struct Breach {
  std::string_view rule;
  canopen::TimePoint time{};
  std::size_t unit = 0;  ///< number of the unit in the world
  std::string text;
};

/// Watches all units of a world for one rule. A unit is known by its number; it may be asked while it is on.
class Judge {
 public:
  explicit Judge(std::string_view rule) noexcept : rule_{rule} {}
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;
  virtual ~Judge() = default;

  /// @p unit is about to be switched on, with its disk as it finds it; or it is off from now on.
  virtual void on_power(const SimulatedUnit& unit, bool on) { static_cast<void>(unit), static_cast<void>(on); }
  /// @p unit has taken @p frame from its socket.
  virtual void on_taken(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
    static_cast<void>(unit), static_cast<void>(frame), static_cast<void>(now);
  }
  /// The bus has taken @p frame of @p unit.
  virtual void on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
    static_cast<void>(unit), static_cast<void>(frame), static_cast<void>(now);
  }
  virtual void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
    static_cast<void>(unit), static_cast<void>(event);
  }
  /// A step of the motors, or a whole cycle, is done; of units that are watched alone.
  virtual void on_step(const SimulatedUnit& unit) { static_cast<void>(unit); }
  virtual void on_cycle(const SimulatedUnit& unit, canopen::TimePoint now) {
    static_cast<void>(unit), static_cast<void>(now);
  }
  /// A turn of the program of @p unit is over, in which it has allocated @p allocated times.
  virtual void on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) {
    static_cast<void>(unit), static_cast<void>(now), static_cast<void>(allocated);
  }
  /// For @p lasting the bus had no room for what has a high identifier.
  virtual void on_full_bus(canopen::Duration lasting) { static_cast<void>(lasting); }
  /// All faults are over.
  virtual void on_calm(canopen::TimePoint now) { static_cast<void>(now); }
  /// The world is at its end.
  virtual void on_end(canopen::TimePoint now) { static_cast<void>(now); }

  [[nodiscard]] const std::optional<Breach>& breach() const noexcept { return breach_; }

 protected:
  /// The rule does not hold at @p now, for unit number @p unit; the first time counts.
  void break_rule(std::size_t unit, canopen::TimePoint now, std::string text) {
    if (!breach_) breach_ = Breach{rule_, now, unit, std::move(text)};
  }

 private:
  std::string_view rule_;
  std::optional<Breach> breach_{};
};

}  // namespace sim
