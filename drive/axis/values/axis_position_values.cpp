// What parameters show of positioning where several blocks know a part of it.
#include "drive/axis/axis.hpp"
#include "drive/positioning/blocks/traversing_block.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::axis_value {
namespace {

constexpr unsigned kBelowCam1 = 8;  // of r2683
constexpr unsigned kBelowCam2 = 9;
constexpr unsigned kFollows = 8;  // of r2684
constexpr unsigned kTargetReached = 10;

double bit(unsigned number, bool set) noexcept {
  return static_cast<double>(static_cast<unsigned>(set) << number);
}

/// Of the reference torque p2003.
double torque_share(const Axis& axis, double torque) noexcept {
  const double reference = axis.references().torque;
  return reference > 0.0 ? torque / reference / row_of(Unit::Percent).si : 0.0;
}

}  // namespace

double position_status(const Axis& axis, std::size_t) noexcept {
  if (!axis.positions()) return 0.0;
  return axis.block<ActualPosition>().status() | axis.block<PositionControl>().status();
}

double encoder_position_status_of(const Axis& axis, std::size_t encoder) noexcept {
  return axis.positions() ? axis.block<ActualPosition>().encoder_status(encoder) : 0.0;
}

double positioner_status_1(const Axis& axis, std::size_t) noexcept {
  if (!axis.positions()) return 0.0;
  const auto& control = axis.block<PositionControl>();
  return axis.block<Positioner>().status_1() + bit(kBelowCam1, control.is_below_cam_1()) +
         bit(kBelowCam2, control.is_below_cam_2());
}

double positioner_status_2(const Axis& axis, std::size_t) noexcept {
  if (!axis.positions()) return 0.0;
  const auto& control = axis.block<PositionControl>();
  return axis.block<Positioner>().status_2() + bit(kFollows, control.is_following()) +
         bit(kTargetReached, control.is_in_position());
}

double fixed_stop_limit(const Axis& axis, std::size_t index) noexcept {
  const auto& positioner = axis.block<Positioner>();
  if (!positioner.limits_torque()) return 0.0;
  const double share = torque_share(axis, positioner.torque_limit());
  return index == 0 ? share : -share;
}

double fixed_stop_torque(const Axis& axis, std::size_t) noexcept {
  return axis.block<Positioner>().is_clamped() ? torque_share(axis, axis.actual().torque_demand) : 0.0;
}

void sort_blocks(Axis& axis, std::size_t, double value) noexcept {
  if (value > 0.0) drive::sort_blocks(axis.block<Positioner>().settings);
}

}  // namespace drive::axis_value
