// Why an axis does not turn, as far as SequenceControl knows.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr States kPulsesOff = in(SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn, Fault);
constexpr States kOperation = in(State::OperationEnabled);

/// "OFF2 by p0844 = r8890.1: <order>." for the one of two inputs that is 0.
std::string off_sentence(P p, const char* name, const std::array<std::uint16_t, 2>& inputs, bool first_is_set) {
  const std::uint16_t input = inputs[first_is_set ? 1 : 0];
  return fmt::format("{} is given by {}: {}.", name, wiring_of(p.axis, input), order_for(p.axis, input, true));
}

bool has_off2(P p) noexcept {
  return p.sequence().effective().has_off2();
}

bool has_off3(P p) noexcept {
  return p.sequence().effective().has_off3();
}

bool always(P) noexcept {
  return true;
}

bool is_halted_without_pulses(P p) noexcept {
  return p.sequence().halts() && p.sequence().settings.halt_option == 0;
}

constexpr std::array kReasons{
    Reason{120, in(NotReadyToSwitchOn), always,
           [](P) -> std::string { return "The axis is in run-up (r0002 = 70): wait for its first cycle."; }},
    Reason{130, kPulsesOff, [](P p) { return p.sequence().settings.commissioning != 0; },
           [](P p) {
             return fmt::format("Commissioning keeps the axis off (p0010 = {}): write p0010 = 0.",
                                p.sequence().settings.commissioning);
           }},
    Reason{140, kPulsesOff,
           [](P p) { return p.sequence().is_inhibited() && p.sequence().settings.commissioning == 0; },
           [](P) -> std::string {
             return "Commissioning of the unit keeps the axis off: write p0009 = 0 on the control unit.";
           }},
    Reason{160, in(FaultReactionActive), always,
           [](P) -> std::string {
             return "The axis still brakes because of the fault (r0002 = 18): wait for its standstill, then "
                    "acknowledge.";
           }},
    Reason{170, in(Stop2Active), always,
           [](P) -> std::string {
             return "STOP2 holds the shaft at zero speed: acknowledge, or give OFF1 (0006h).";
           }},
    Reason{180, in(SwitchOnDisabled), has_off2,
           [](P p) {
             return off_sentence(p, "OFF2", {844, 845}, p.sequence().effective().no_off2);
           }},
    Reason{190, in(SwitchOnDisabled), has_off3,
           [](P p) {
             return off_sentence(p, "OFF3", {848, 849}, p.sequence().effective().no_off3);
           }},
    Reason{200, in(SwitchOnDisabled), [](P p) { return p.sequence().is_on() && !has_off2(p) && !has_off3(p); },
           [](P p) {
             const bool panel = p.axis.block<OperatorPanel>().is_active();
             return fmt::format("ON ({}) is still set and needs an edge: {}.", commanded_by(p.axis, 840),
                                panel ? "switch it off and on at the panel" : "send 0006h first, then 000Fh");
           }},
    Reason{
        205, in(ReadyToSwitchOn), [](P p) { return p.sequence().withholds_on(); },
        [](P p) {
          return fmt::format(
              "ON ({}) is still there from before the connection was lost or an operator panel led (A07200), and "
              "needs an edge: send 0006h first, then 000Fh.",
              wiring_of(p.axis, 840));
        }},
    Reason{210, in(ReadyToSwitchOn), [](P p) { return !p.sequence().is_on() && !p.sequence().withholds_on(); },
           [](P p) {
             const bool panel = p.axis.block<OperatorPanel>().is_active();
             return fmt::format("ON is missing ({}): {}{}.", commanded_by(p.axis, 840),
                                order_to(p.axis, 840, true),
                                panel ? "" : ", together with operation enable 000Fh");
           }},
    Reason{220, in(SwitchedOn), [](P p) { return !p.sequence().effective().enable_operation; },
           [](P p) {
             return fmt::format("The operation enable is missing ({}): {}.", wiring_of(p.axis, 852),
                                order_for(p.axis, 852, true));
           }},
    Reason{230, in(SwitchedOn), is_halted_without_pulses,
           [](P) -> std::string {
             return "A halt keeps the pulses off (bit 8 of the controlword with p8791 = 0): clear bit 8.";
           }},
    Reason{240, in(SwitchedOn), [](P p) { return !p.sequence().effective().infeed_operates; },
           [](P p) {
             return fmt::format("The infeed does not operate ({}, r0002 = 23): {} before p0857 ends in F07840.",
                                wiring_of(p.axis, 864), order_for(p.axis, 864, true));
           }},
    Reason{260, in(Off1Braking), always,
           [](P p) {
             return fmt::format(
                 "OFF1 brakes the axis (p1121 = {} s): wait for Ready to switch on, or give ON again (000Fh).",
                 plain(p.channel().settings.ramp_down_time));
           }},
    Reason{270, in(QuickStopActive), always,
           [](P p) {
             return fmt::format(
                 "OFF3 brakes the axis (p1135 = {} s) and is not taken back: wait, then send 0006h and 000Fh.",
                 plain(p.channel().settings.off3_ramp_down_time));
           }},
    Reason{520, kOperation, halts,
           [](P p) {
             return fmt::format(
                 "A halt keeps the axis at zero (bit 8 of the controlword with p8791 = {}): clear bit 8.",
                 p.sequence().settings.halt_option);
           }},
};

}  // namespace

std::span<const Reason> SequenceControl::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
