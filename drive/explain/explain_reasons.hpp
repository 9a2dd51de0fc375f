#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "drive/axis/axis.hpp"
#include "drive/base/units.hpp"

/// What explain() is made of.
namespace drive::explanation {

/// An axis after a cycle.
struct Picture {
  const Axis& axis;

  State state() const noexcept { return axis.actual().state; }
  const SequenceControl& sequence() const noexcept { return axis.block<SequenceControl>(); }
  const SetpointChannel& channel() const noexcept { return axis.block<SetpointChannel>(); }
  const SpeedControl& control() const noexcept { return axis.block<SpeedControl>(); }
  const TorqueSetpoint& torque() const noexcept { return axis.block<TorqueSetpoint>(); }
};

/// A set of states, one bit each.
using States = unsigned;
template <class... State>
constexpr States in(State... states) noexcept {
  return ((1U << static_cast<unsigned>(states)) | ...);
}

/// A reason that an axis does not turn in one of @p states while it holds; the lowest rank is told first.
struct Reason {
  int rank;
  States states;
  bool (*holds)(const Picture&);
  std::string (*text)(const Picture&);
};

inline constexpr double kNothing = 1e-9;
inline bool is_zero(double value) noexcept {
  return std::abs(value) < kNothing;
}
/// Whether the torque setpoint leads.
inline bool torque_leads(const Picture& picture) noexcept {
  return picture.control().torque_control();
}
/// Whether a halt takes the setpoint to zero.
inline bool halts(const Picture& picture) noexcept {
  return picture.sequence().halts() && picture.sequence().settings.halt_option > 0;
}

/// Above it a shaft is said to turn (rad/s).
inline constexpr double kSlowest = 0.5 * kRpm;
/// What the positioner does with an axis that turns, to be put behind a sentence; empty if it does nothing.
std::string positioning_text(const Picture& picture);
/// Whether what hangs on the shaft turns it: it gives work to the shaft.
bool load_drives(const Picture& picture) noexcept;

/// "p0844 = r8890.1": what the BICO input @p input is connected to.
std::string wiring_of(const DriveObject& object, std::uint16_t input);
/// What makes the binector input @p input be @p wanted, as an order.
std::string order_for(const DriveObject& object, std::uint16_t input, bool wanted);
/// The same of @p axis, or that an operator panel gives what that input is for.
std::string commanded_by(const Axis& axis, std::uint16_t input);
/// What makes the commanded input be @p wanted, as an order.
std::string order_to(const Axis& axis, std::uint16_t input, bool wanted);
/// A number with at most three decimals and without superfluous zeros.
std::string plain(double number);

}  // namespace drive::explanation
