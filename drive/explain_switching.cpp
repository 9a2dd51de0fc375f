// Why an axis is not in Operation enabled.
#include <array>

#include <fmt/format.h>

#include "drive/explain_reasons.hpp"

namespace drive::explanation {
namespace {

using enum State;
using P = const Picture&;

/// "OFF2 by p0844 = r8890.1: <order>." for the one of two inputs that is 0.
std::string off_sentence(P p, const char* name, const std::array<std::uint16_t, 2>& inputs, bool first_is_set) {
  const std::uint16_t input = inputs[first_is_set ? 1 : 0];
  return fmt::format("{} is given by {}: {}.", name, wiring_of(p.axis, input), order_for(p.axis, input, true));
}

bool has_off2(P p) noexcept {
  return p.sequence().inputs.has_off2();
}
bool has_off3(P p) noexcept {
  return p.sequence().inputs.has_off3();
}
bool always(P) noexcept {
  return true;
}
bool is_halted_without_pulses(P p) noexcept {
  return p.sequence().halts() && p.sequence().settings.halt_option == 0;
}
bool has_dc_link(P p) noexcept {
  return p.axis.block<PowerUnit>().has_link();
}

constexpr States kPulsesOff = in(SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn, Fault);

std::string driven_sentence(P p) {
  return fmt::format("The load drives the shaft at {:.0f} rpm{}", p.axis.actual().speed / kRpm,
                     p.axis.drive_train().is_held_back() ? ", the most that its rotor holds" : "");
}

constexpr std::array kReasons{
    Reason{
        kPulsesOff, load_drives,
        [](P p) { return driven_sentence(p) + ", since the pulses are off: take the load away, or brake it."; }},
    Reason{in(FaultReactionActive, Stop2Active, Off1Braking, QuickStopActive),
           [](P p) { return load_drives(p) && p.axis.is_at_torque_limit(); },
           [](P p) {
             return driven_sentence(p) +
                    " against the torque limit: take the load away, or raise p1520, p1521 and p0640.";
           }},
    Reason{in(NotReadyToSwitchOn), always,
           [](P) -> std::string { return "The axis is in run-up (r0002 = 70): wait for its first cycle."; }},
    Reason{kPulsesOff, [](P p) { return p.sequence().settings.commissioning != 0; },
           [](P p) {
             return fmt::format("Commissioning keeps the axis off (p0010 = {}): write p0010 = 0.",
                                p.sequence().settings.commissioning);
           }},
    Reason{kPulsesOff, [](P p) { return p.sequence().is_inhibited() && p.sequence().settings.commissioning == 0; },
           [](P) -> std::string {
             return "Commissioning of the unit keeps the axis off: write p0009 = 0 on the control unit.";
           }},
    Reason{in(SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn),
           [](P p) { return p.axis.identification().due() != IdentificationPart::None; },
           [](P p) {
             const bool stands = p.axis.identification().due() == IdentificationPart::Standstill;
             return fmt::format("{} is selected: the next ON measures the motor {}; write 0 to take it back.",
                                stands ? "p1910 (A07991)" : "p1960 (A07980)",
                                stands ? "at standstill" : "turning, up to p1082");
           }},
    Reason{in(FaultReactionActive), always,
           [](P) -> std::string {
             return "The axis still brakes because of the fault (r0002 = 18): wait for its standstill, then "
                    "acknowledge.";
           }},
    Reason{in(Stop2Active), always,
           [](P) -> std::string {
             return "STOP2 holds the shaft at zero speed: acknowledge, or give OFF1 (0006h).";
           }},
    Reason{in(SwitchOnDisabled), has_off2,
           [](P p) {
             return off_sentence(p, "OFF2", {844, 845}, p.sequence().inputs.no_off2);
           }},
    Reason{in(SwitchOnDisabled), has_off3,
           [](P p) {
             return off_sentence(p, "OFF3", {848, 849}, p.sequence().inputs.no_off3);
           }},
    Reason{in(SwitchOnDisabled), [](P p) { return p.sequence().is_on() && !has_off2(p) && !has_off3(p); },
           [](P p) {
             return fmt::format("ON ({}) is still set and needs an edge: send 0006h first, then 000Fh.",
                                wiring_of(p.axis, 840));
           }},
    Reason{in(ReadyToSwitchOn), [](P p) { return !p.sequence().is_on(); },
           [](P p) {
             return fmt::format("ON is missing ({}): {}, together with operation enable 000Fh.",
                                wiring_of(p.axis, 840), order_for(p.axis, 840, true));
           }},
    Reason{in(SwitchedOn), [](P p) { return !p.sequence().inputs.enable_operation; },
           [](P p) {
             return fmt::format("The operation enable is missing ({}): {}.", wiring_of(p.axis, 852),
                                order_for(p.axis, 852, true));
           }},
    Reason{in(SwitchedOn), is_halted_without_pulses,
           [](P) -> std::string {
             return "A halt keeps the pulses off (bit 8 of the controlword with p8791 = 0): clear bit 8.";
           }},
    Reason{in(SwitchedOn), [](P p) { return !p.sequence().inputs.infeed_operates; },
           [](P p) {
             return fmt::format("The infeed does not operate ({}, r0002 = 23): {} before p0857 ends in F07840.",
                                wiring_of(p.axis, 864), order_for(p.axis, 864, true));
           }},
    Reason{in(SwitchedOn), [](P p) { return !has_dc_link(p); },
           [](P p) {
             return fmt::format(
                 "The DC link has {} V, less than {} V: switch the line on before p0857 ends in F07802.",
                 plain(p.axis.block<PowerUnit>().dc_voltage()), plain(p.axis.context().supply.undervoltage));
           }},
    Reason{in(Off1Braking), always,
           [](P p) {
             return fmt::format(
                 "OFF1 brakes the axis (p1121 = {} s): wait for Ready to switch on, or give ON again (000Fh).",
                 plain(p.channel().settings.ramp_down_time));
           }},
    Reason{in(QuickStopActive), always,
           [](P p) {
             return fmt::format(
                 "OFF3 brakes the axis (p1135 = {} s) and is not taken back: wait, then send 0006h and 000Fh.",
                 plain(p.channel().settings.off3_ramp_down_time));
           }},
};

}  // namespace

std::span<const Reason> switching_reasons() noexcept {
  return kReasons;
}

}  // namespace drive::explanation
