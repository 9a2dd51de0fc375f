// Why an axis does not turn, as far as SetpointChannel knows.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "drive/base/units.hpp"
#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr States kOperation = in(State::OperationEnabled);

/// The ramp follows the setpoint channel.
bool ramp_leads(P p) noexcept {
  const bool positions = p.axis.positions() && p.axis.block<PositionControl>().is_enabled();
  return !torque_leads(p) && !halts(p) && !p.axis.brake_opens() && !positions;
}

/// In velocity mode, bits 4 to 6 of the controlword are enables too.
std::string ramp_sentence(P p, const char* what, std::uint16_t input, unsigned bit, bool is_set) {
  if (p.control().has_ramp_bits() && !is_set)
    return fmt::format("{} (bit {} of the controlword in velocity mode): send 007Fh.", what, bit);
  return fmt::format("{} ({}): {}.", what, wiring_of(p.axis, input), order_for(p.axis, input, true));
}

bool has_both_jogs(P p) noexcept {
  return p.axis.jogs() && p.axis.block<Jog>().has_both();
}

/// The setpoint of the setpoint channel after its inversion.
double directed(P p) noexcept {
  return p.channel().effective().invert_setpoint ? -p.channel().sum() : p.channel().sum();
}

double behind_the_ramp(P p) noexcept {
  return p.channel().effective().speed_setpoint_1 + p.channel().effective().speed_setpoint_2;
}

bool has_setpoint(P p) noexcept {
  return !is_zero(directed(p)) || !is_zero(behind_the_ramp(p));
}

/// Whether the setpoint is for positive speeds.
bool is_forward(P p) noexcept {
  return directed(p) + behind_the_ramp(p) > 0.0;
}

bool is_direction_inhibited(P p) noexcept {
  return !is_zero(directed(p)) &&
         (directed(p) > 0.0 ? p.channel().effective().inhibit_positive : p.channel().effective().inhibit_negative);
}

double direction_limit(P p) noexcept {
  const SetpointChannel::Settings& settings = p.channel().settings;
  const SetpointChannel::Inputs& inputs = p.channel().effective();
  return is_forward(p) ? std::min(settings.speed_limit_positive, inputs.forward_limit)
                       : std::max(settings.speed_limit_negative, inputs.backward_limit);
}

constexpr std::array kReasons{
    Reason{530, kOperation, [](P p) { return ramp_leads(p) && !p.channel().effective().enable_ramp; },
           [](P p) {
             return ramp_sentence(p, "The ramp-function generator is held at zero", 1140, 4,
                                  p.channel().inputs.vl_enable_ramp);
           }},
    Reason{540, kOperation, [](P p) { return ramp_leads(p) && !p.channel().effective().continue_ramp; },
           [](P p) {
             return ramp_sentence(p, "The ramp-function generator is frozen", 1141, 5,
                                  p.channel().inputs.vl_unlock_ramp);
           }},
    Reason{550, kOperation, [](P p) { return ramp_leads(p) && !p.channel().effective().enable_setpoint; },
           [](P p) {
             return ramp_sentence(p, "The setpoint is not enabled", 1142, 6, p.channel().inputs.vl_reference_ramp);
           }},
    Reason{560, kOperation, has_both_jogs,
           [](P) -> std::string {
             return "Both jog bits are set, which is setpoint 0: take one of p1055 and p1056 away.";
           }},
    Reason{570, kOperation,
           [](P p) { return ramp_leads(p) && !has_both_jogs(p) && !has_setpoint(p) && p.axis.jogs(); },
           [](P) -> std::string { return "The jog speed is 0: write p1058 and p1059."; }},
    Reason{580, kOperation, [](P p) { return ramp_leads(p) && !has_setpoint(p) && !p.axis.jogs(); },
           [](P p) -> std::string {
             if (p.axis.block<OperatorPanel>().is_active())
               return "The speed setpoint of the operator panel is 0: give one there.";
             const bool channel = p.axis.has_setpoint_channel();
             const std::string wiring =
                 (channel ? wiring_of(p.axis, 1070) + ", " : std::string{}) + wiring_of(p.axis, 1155);
             return fmt::format(
                 "The speed setpoint is 0 ({}): send a setpoint ({:04X}h), or connect {} to another source.",
                 wiring, p.axis.speed_setpoint().setpoint, channel ? "p1070" : "p1155");
           }},
    Reason{590, kOperation, [](P p) { return ramp_leads(p) && is_zero(p.channel().settings.maximum_speed); },
           [](P) -> std::string { return "The maximum speed is 0 (p1082): write p1082."; }},
    Reason{600, kOperation, [](P p) { return ramp_leads(p) && has_setpoint(p) && is_direction_inhibited(p); },
           [](P p) {
             const bool forward = directed(p) > 0.0;
             const std::uint16_t input = forward ? 1111 : 1110;
             return fmt::format("The {} direction is inhibited ({}): {}, or reverse the setpoint.",
                                forward ? "positive" : "negative", wiring_of(p.axis, input),
                                order_for(p.axis, input, false));
           }},
    Reason{610, kOperation, [](P p) { return ramp_leads(p) && has_setpoint(p) && is_zero(direction_limit(p)); },
           [](P p) {
             const bool forward = is_forward(p);
             return fmt::format("The speed limit of the {} direction is 0: raise {} ({}).",
                                forward ? "positive" : "negative", forward ? "p1083" : "p1086",
                                wiring_of(p.axis, forward ? 1085 : 1088));
           }},
    Reason{650, kOperation,
           [](P p) { return ramp_leads(p) && !is_zero(p.channel().input()) && !p.axis.is_at_torque_limit(); },
           [](P p) {
             return fmt::format("The ramp begins (p1120 = {} s, to {} rpm): wait, or shorten it.",
                                plain(p.channel().settings.ramp_up_time), plain(p.channel().input() / kRpm));
           }},
};

}  // namespace

std::span<const Reason> SetpointChannel::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
