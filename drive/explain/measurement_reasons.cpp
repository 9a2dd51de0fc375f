// Why an axis does not turn, as far as Measurement knows.
#include <array>

#include <fmt/format.h>

#include "drive/base/units.hpp"
#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr States kPulsesOff = in(SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn, Fault);

std::string driven_sentence(P p) {
  return fmt::format("The load drives the shaft at {:.0f} rpm{}", p.axis.actual().speed / kRpm,
                     p.axis.drive_train().is_held_back() ? ", the most that its rotor holds" : "");
}

constexpr std::array kReasons{
    Reason{
        100, kPulsesOff, load_drives,
        [](P p) { return driven_sentence(p) + ", since the pulses are off: take the load away, or brake it."; }},
    Reason{110, in(FaultReactionActive, Stop2Active, Off1Braking, QuickStopActive),
           [](P p) { return load_drives(p) && p.axis.is_at_torque_limit(); },
           [](P p) {
             return driven_sentence(p) +
                    " against the torque limit: take the load away, or raise p1520, p1521 and p0640.";
           }},
};

}  // namespace

std::span<const Reason> Measurement::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
