// Why an axis does not turn.
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "cia402/drive/drive_state.hpp"
#include "cia402/face.hpp"
#include "cia402/objects/object_index.hpp"

namespace cia402 {
namespace {

/// The axis as it is between two cycles.
struct Picture {
  const canopen::Node& node;
  const drive::Axis& drive;
  const AxisObjects& objects;
  std::size_t number;

  const Axis& axis() const noexcept { return objects.axis(); }
  const AxisValues& values() const noexcept { return objects.values(); }
  unsigned index(std::uint16_t first) const noexcept { return object::index_on_axis(first, number); }
  bool is_enabled() const noexcept { return axis().state() == State::OperationEnabled; }
  bool is_in(Mode mode) const noexcept { return is_enabled() && !axis().is_halted() && axis().mode() == mode; }
};
using P = const Picture&;

struct Reason {
  bool (*holds)(P);
  std::string (*text)(P);
};

bool stands_in(P p, State state) noexcept {
  return p.axis().state() == state;
}
bool is_cyclic(P p) noexcept {
  return p.is_in(Mode::CyclicSynchronousPosition) || p.is_in(Mode::CyclicSynchronousVelocity) ||
         p.is_in(Mode::CyclicSynchronousTorque);
}

constexpr std::array kReasons{
    Reason{[](P p) { return stands_in(p, State::Fault) || stands_in(p, State::FaultReactionActive); },
           [](P p) {
             return fmt::format(
                 "Error {:04X}h ({:04X}h) holds the axis in {}: remove its cause, then let bit 7 of the "
                 "controlword rise.",
                 p.values().error_code.get(), p.index(object::kErrorCode), name_of(p.axis().state()));
           }},
    Reason{
        [](P p) { return p.node.state() != canopen::NmtState::Operational && p.values().controlword.get() == 0; },
        [](P p) {
          return fmt::format("The node is {}, so that no PDO is received: send the NMT command start (01h).",
                             canopen::name_of(p.node.state()));
        }},
    Reason{[](P p) { return !state_of(p.drive).has_voltage; },
           [](P) -> std::string { return "The DC link has no voltage: switch the supply on."; }},
    Reason{[](P p) { return stands_in(p, State::SwitchOnDisabled); },
           [](P p) {
             return fmt::format("The axis is in Switch on disabled: write 0006h, 0007h and 000Fh to {:04X}h.",
                                p.index(object::kControlword));
           }},
    Reason{[](P p) { return stands_in(p, State::ReadyToSwitchOn) || stands_in(p, State::SwitchedOn); },
           [](P p) {
             return fmt::format("The axis is in {}: write 000Fh to {:04X}h.", name_of(p.axis().state()),
                                p.index(object::kControlword));
           }},
    Reason{[](P p) { return stands_in(p, State::QuickStopActive); },
           [](P p) {
             return fmt::format("Quick stop is active ({:04X}h bit 2 = 0): write 000Fh, or disable the voltage.",
                                p.index(object::kControlword));
           }},
    Reason{[](P p) { return p.is_enabled() && !state_of(p.drive).follows; },
           [](P) -> std::string { return "The motor is magnetised, or its brake opens: it turns after that."; }},
    Reason{[](P p) { return p.is_enabled() && p.axis().is_halted(); },
           [](P p) { return fmt::format("Halt: bit 8 of {:04X}h is set.", p.index(object::kControlword)); }},
    Reason{
        [](P p) { return p.is_in(Mode::None); },
        [](P p) { return fmt::format("No mode is chosen: write {:04X}h.", p.index(object::kModesOfOperation)); }},
    Reason{[](P p) { return p.is_in(Mode::ProfilePosition) && p.axis().modes().is_idle(); },
           [](P p) {
             return fmt::format("No set-point was handed over: write {:04X}h, then let bit 4 of {:04X}h rise.",
                                p.index(object::kTargetPosition), p.index(object::kControlword));
           }},
    Reason{[](P p) { return p.is_in(Mode::ProfileVelocity) && p.values().target_velocity.get() == 0; },
           [](P p) { return fmt::format("The target velocity {:04X}h is 0.", p.index(object::kTargetVelocity)); }},
    Reason{[](P p) { return p.is_in(Mode::ProfileTorque) && p.values().target_torque.get() == 0; },
           [](P p) { return fmt::format("The target torque {:04X}h is 0.", p.index(object::kTargetTorque)); }},
    Reason{
        [](P p) { return p.is_in(Mode::Velocity) && p.values().vl_target_velocity.get() == 0; },
        [](P p) { return fmt::format("The target velocity {:04X}h is 0.", p.index(object::kVlTargetVelocity)); }},
    Reason{[](P p) {
             constexpr unsigned kRampBits = 0x70;
             return p.is_in(Mode::Velocity) && (p.values().controlword.get() & kRampBits) != kRampBits;
           },
           [](P p) {
             return fmt::format("The ramp is not enabled, unlocked and led: set bits 4, 5 and 6 of {:04X}h.",
                                p.index(object::kControlword));
           }},
    Reason{[](P p) { return p.is_in(Mode::Homing) && !p.axis().modes().homing().is_running(); },
           [](P p) {
             return fmt::format("No homing runs: choose a method in {:04X}h, then let bit 4 of {:04X}h rise.",
                                p.index(object::kHomingMethod), p.index(object::kControlword));
           }},
    Reason{[](P p) { return is_cyclic(p) && (p.values().statusword.get() & 0x1000U) == 0; },
           [](P) -> std::string {
             return "No set-point is followed (statusword bit 12 = 0): send one with each SYNC.";
           }},
    Reason{[](P p) { return p.is_in(Mode::InterpolatedPosition) && (p.values().statusword.get() & 0x1000U) == 0; },
           [](P p) {
             return fmt::format("Interpolation is not active: set bit 4 of {:04X}h.",
                                p.index(object::kControlword));
           }},
    Reason{[](P p) { return p.is_enabled() && p.axis().inputs().levels().at(Signal::NegativeLimit); },
           [](P) -> std::string { return "The negative limit switch is reached: nothing moves towards it."; }},
    Reason{[](P p) { return p.is_enabled() && p.axis().inputs().levels().at(Signal::PositiveLimit); },
           [](P) -> std::string { return "The positive limit switch is reached: nothing moves towards it."; }},
    Reason{[](P p) { return p.is_enabled() && p.values().max_torque.get() == 0; },
           [](P p) { return fmt::format("The torque limit {:04X}h is 0.", p.index(object::kMaxTorque)); }},
};

}  // namespace

std::vector<std::string> Face::explain(std::size_t number, std::vector<std::string> commanding) const {
  const Picture picture{node_, runner_.unit().axes()[number - 1], axes_[number - 1], number};
  std::vector<std::string> sentences = std::move(commanding);
  const bool turns = std::abs(picture.drive.actual().speed) > drive::kRpm;
  if (!sentences.empty() || (turns && picture.is_enabled())) return sentences;
  for (const Reason& reason : kReasons)
    if (reason.holds(picture)) sentences.push_back(reason.text(picture));
  return sentences;
}

}  // namespace cia402
