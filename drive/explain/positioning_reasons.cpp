// Why an axis does not turn, as far as positioning knows.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr States kOperation = in(State::OperationEnabled);
constexpr double kShare = 100.0;  // %

const Positioner& positioner(P p) noexcept {
  return p.axis.block<Positioner>();
}
const PositionControl& control(P p) noexcept {
  return p.axis.block<PositionControl>();
}
const PositionerInputs& inputs(P p) noexcept {
  return positioner(p).inputs;
}
bool positions(P p) noexcept {
  return p.axis.positions() && !torque_leads(p) && !p.axis.jogs() && !p.axis.brake_opens();
}
/// The setpoint is led, and something could begin.
bool is_ready(P p) noexcept {
  return positions(p) && positioner(p).is_enabled();
}
bool has_task(P p) noexcept {
  return is_ready(p) && positioner(p).has_task();
}
bool has_none(P p) noexcept {
  return is_ready(p) && !positioner(p).has_task();
}
bool is_for_mdi(P p) noexcept {
  return inputs(p).mdi;
}

bool stands_at_limit(P p, Direction direction) {
  const Travel& travel = positioner(p).travel();
  return travel.is_still() && travel.is_at_limit(direction) && !positioner(p).tracks();
}
bool stands_on_cam(P p, Direction direction) {
  return positioner(p).stop_cams().bars(direction);
}
const char* name_of(Direction direction) noexcept {
  return direction == Direction::Positive ? "positive" : "negative";
}
const char* opposite_of(Direction direction) noexcept {
  return direction == Direction::Positive ? "negative" : "positive";
}

template <Direction kDirection>
bool is_on_cam(P p) {
  return is_ready(p) && stands_on_cam(p, kDirection);
}
template <Direction kDirection>
std::string cam_text(P p) {
  constexpr std::uint16_t kInput = kDirection == Direction::Positive ? 2570 : 2569;
  return fmt::format("The axis is on the STOP cam of the {} direction ({}): move it in the {} direction.",
                     name_of(kDirection), wiring_of(p.axis, kInput), opposite_of(kDirection));
}
template <Direction kDirection>
bool is_at_limit(P p) {
  return is_ready(p) && stands_at_limit(p, kDirection);
}
template <Direction kDirection>
std::string limit_text(P p) {
  constexpr bool kPositive = kDirection == Direction::Positive;
  const TravelConditions& bounds = positioner(p).travel().conditions();
  return fmt::format(
      "The setpoint is at the limit of the {} direction, {:.0f} LU ({}): only travel in the {} one begins.",
      name_of(kDirection), kPositive ? bounds.upper : bounds.lower, wiring_of(p.axis, kPositive ? 2579 : 2578),
      opposite_of(kDirection));
}

/// What leads the setpoint; a block by its number.
std::string mode_text(P p) {
  const BlockMode& blocks = positioner(p).blocks();
  if (blocks.is_active()) return fmt::format("traversing block {}", blocks.block().number);
  return positioner(p).mode() == PositionerMode::Basic ? "no task" : std::string{positioner(p).mode_name()};
}

std::string start_text(P p) {
  if (is_for_mdi(p))
    return fmt::format("MDI is selected ({}) and no setpoint was taken over since: {}.", wiring_of(p.axis, 2647),
                       order_for(p.axis, inputs(p).mdi_continuous ? 2647 : 2650, true));
  return fmt::format(
      "The positioner has no task (r2669 = 0): start a block ({}), select MDI ({}), jog ({}) or reference ({}).",
      wiring_of(p.axis, 2631), wiring_of(p.axis, 2647), wiring_of(p.axis, 2589), wiring_of(p.axis, 2595));
}

std::string waiting_text(P p) {
  const Positioner& axis = positioner(p);
  if (axis.blocks().awaits_signal())
    return fmt::format(
        "Traversing block {} waits for its signal ({}).", axis.blocks().block().number,
        axis.settings.external_change != 0 ? wiring_of(p.axis, 2633) : "p2632 = 0, measuring probe");
  if (axis.blocks().is_waiting())
    return fmt::format("Traversing block {} waits {} ms more.", axis.blocks().block().number,
                       plain(axis.blocks().remaining_wait() * 1e3));
  return fmt::format("The setpoint of {} stands {} LU before the actual value is in the window p2544 = {} LU.",
                     mode_text(p), plain(control(p).deviation()), plain(control(p).settings.positioning_window));
}

bool has_goal_velocity(P p) noexcept {
  return positioner(p).travel().goal().velocity > 0.0;
}
/// In a block WAIT, which is to stand.
bool waits_in_block(P p) noexcept {
  return positioner(p).blocks().is_waiting();
}

constexpr std::array kReasons{
    Reason{700, kOperation, [](P p) { return positions(p) && !inputs(p).position_valid; },
           [](P p) {
             return fmt::format("The actual position is not valid (r2526.0 = 0, {}): see p2502 and the encoder.",
                                wiring_of(p.axis, 2658));
           }},
    Reason{705, kOperation,
           [](P p) { return positions(p) && inputs(p).position_valid && !positioner(p).is_enabled(); },
           [](P p) {
             const bool with_encoder = p.control().settings.control_mode == 21;
             return fmt::format("The positioner is not enabled (r2526.3 = 0, {}; {}, {}){}: {}.",
                                wiring_of(p.axis, 2656), wiring_of(p.axis, 2549), wiring_of(p.axis, 2550),
                                with_encoder ? "" : ", as position control needs p1300 = 21",
                                with_encoder ? "enable position control" : "write p1300 = 21 with the pulses off");
           }},
    Reason{710, kOperation, is_on_cam<Direction::Negative>, cam_text<Direction::Negative>},
    Reason{711, kOperation, is_on_cam<Direction::Positive>, cam_text<Direction::Positive>},
    Reason{715, kOperation, is_at_limit<Direction::Negative>, limit_text<Direction::Negative>},
    Reason{716, kOperation, is_at_limit<Direction::Positive>, limit_text<Direction::Positive>},
    Reason{720, kOperation, [](P p) { return is_ready(p) && !inputs(p).no_reject; },
           [](P p) {
             return fmt::format("Tasks are rejected ({}): {}.", wiring_of(p.axis, 2641),
                                order_for(p.axis, 2641, true));
           }},
    Reason{725, kOperation, [](P p) { return is_ready(p) && !inputs(p).no_intermediate_stop; },
           [](P p) {
             return fmt::format("An intermediate stop holds {} ({}): {}.", mode_text(p), wiring_of(p.axis, 2640),
                                order_for(p.axis, 2640, true));
           }},
    Reason{730, kOperation, [](P p) { return has_none(p) && !positioner(p).is_referenced(); },
           [](P p) {
             return fmt::format(
                 "The reference point is not set (r2684.11 = 0), which blocks and absolute targets need: search "
                 "it ({}) or set "
                 "it ({}).",
                 wiring_of(p.axis, 2595), wiring_of(p.axis, 2596));
           }},
    Reason{740, kOperation, has_none, start_text},
    Reason{750, kOperation, [](P p) { return has_task(p) && is_zero(inputs(p).velocity_override); },
           [](P p) {
             return fmt::format("The velocity override is 0 % ({}): raise it; {} goes on then.",
                                wiring_of(p.axis, 2646), mode_text(p));
           }},
    Reason{755, kOperation,
           [](P p) {
             return has_task(p) && !has_goal_velocity(p) && !waits_in_block(p) &&
                    !is_zero(inputs(p).velocity_override);
           },
           [](P p) {
             return fmt::format("The velocity of {} is 0 (r2672; MDI: {}).", mode_text(p),
                                wiring_of(p.axis, 2643));
           }},
    Reason{760, kOperation,
           [](P p) {
             return has_task(p) && positioner(p).travel().is_still() &&
                    (has_goal_velocity(p) || waits_in_block(p)) && !positioner(p).travel().is_interrupted() &&
                    !is_zero(inputs(p).velocity_override);
           },
           waiting_text},
};

}  // namespace

std::span<const explanation::Reason> Positioner::reasons() noexcept {
  return kReasons;
}

std::string explanation::positioning_text(const Picture& picture) {
  if (!has_task(picture)) return {};
  const Positioner& axis = positioner(picture);
  const std::string way = axis.travel().has_target() ? fmt::format(" to {:.0f} LU, {:.0f} LU to go", axis.target(),
                                                                   axis.residual_distance())
                                                     : std::string{", endless"};
  return fmt::format("; {}{}, at {:.0f} LU, override {} %", mode_text(picture), way,
                     picture.axis.block<ActualPosition>().position(), plain(axis.effective_override() * kShare));
}

}  // namespace drive
