// Why an axis does not turn, as far as TorqueSetpoint knows.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr States kOperation = in(State::OperationEnabled);

double torque_limit(P p) noexcept {
  const double wanted = torque_leads(p) ? p.torque().inputs.setpoint : p.axis.actual().speed_demand;
  return wanted >= 0.0 ? p.axis.effective_torque_limits().upper : -p.axis.effective_torque_limits().lower;
}

constexpr std::array kReasons{
    Reason{620, kOperation,
           [](P p) { return torque_leads(p) && !halts(p) && is_zero(p.torque().inputs.setpoint); },
           [](P p) {
             return fmt::format(
                 "Torque control is active and its setpoint is 0 ({}): send 6071h, or choose speed control "
                 "(6060h = 3).",
                 wiring_of(p.axis, 1503));
           }},
    Reason{630, kOperation, [](P p) { return torque_limit(p) < kNothing; },
           [](P p) {
             return fmt::format(
                 "The torque limits leave no torque in this direction ({} to {} N·m): widen p1520 and p1521.",
                 plain(p.axis.effective_torque_limits().lower), plain(p.axis.effective_torque_limits().upper));
           }},
    Reason{640, kOperation, [](P p) { return p.axis.is_at_torque_limit() && torque_limit(p) >= kNothing; },
           [](P p) {
             return fmt::format(
                 "The motor is at its torque limit ({} N·m) and does not turn: take the load or the brake away, "
                 "or raise p1520, p1521 and p0640.",
                 plain(torque_limit(p)));
           }},
    Reason{660, kOperation,
           [](P p) {
             return torque_leads(p) && !is_zero(p.torque().inputs.setpoint) && !p.axis.is_at_torque_limit();
           },
           [](P p) {
             return fmt::format("The torque setpoint of {} N·m does not move the load: raise it.",
                                plain(p.torque().inputs.setpoint));
           }},
};

}  // namespace

std::span<const Reason> TorqueSetpoint::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
