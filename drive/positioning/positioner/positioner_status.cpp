// What the basic positioner shows.
#include <algorithm>
#include <cmath>

#include "drive/positioning/positioner/positioner.hpp"

namespace drive {
namespace {

/// A word from bits, each where its number says.
class Word {
 public:
  Word& bit(unsigned number, bool set) noexcept {
    word_ = static_cast<std::uint16_t>(word_ | static_cast<unsigned>(set) << number);
    return *this;
  }
  std::uint16_t value() const noexcept { return word_; }

 private:
  std::uint16_t word_ = 0;
};

constexpr unsigned kMdiBit = 15;         // of r2670
constexpr double kBelowHalf = 0.499999;  // LU, is rounded to 0

}  // namespace

/// What a modulo axis shows is rounded, a half away from zero, and that must not lead out of its range.
double Positioner::position() const noexcept {
  const double position = travel_.position();
  const bool wraps = modulo_range_ > 0.0 && position > -1.0 && position < modulo_range_;
  return wraps ? std::clamp(position, -kBelowHalf, modulo_range_ - 1.0 + kBelowHalf) : position;
}

double Positioner::mode_word() const noexcept {
  const bool setting_up = mode() == PositionerMode::Mdi && mdi_.is_setting_up();
  const int code = setting_up ? kSettingUpCode : code_of(mode());
  return flying_.is_active() ? code | kFlyingCode : code;
}

std::string_view Positioner::mode_name() const noexcept {
  if (mode() == PositionerMode::Mdi && mdi_.is_setting_up()) return "MDI setting-up";
  return name_of(mode());
}

double Positioner::block_word() const noexcept {
  if (blocks_.is_active()) return blocks_.block().number;
  return mdi_.is_active() ? static_cast<double>(1U << kMdiBit) : 0.0;
}

bool Positioner::has_target() const noexcept {
  return mode() != PositionerMode::Basic && travel_.has_target();
}

double Positioner::target() const noexcept {
  if (!has_target()) return 0.0;
  const double target = travel_.goal().target;
  return modulo_range_ > 0.0 ? target - modulo_range_ * std::floor(target / modulo_range_) : target;
}

double Positioner::programmed_velocity() const noexcept {
  return mode() != PositionerMode::Basic ? travel_.goal().velocity : 0.0;
}

double Positioner::acceleration_share() const noexcept {
  return mode() != PositionerMode::Basic ? travel_.goal().acceleration : 1.0;
}

double Positioner::deceleration_share() const noexcept {
  return mode() != PositionerMode::Basic ? travel_.goal().deceleration : 1.0;
}

double Positioner::task() const noexcept {
  return blocks_.is_active() ? static_cast<double>(blocks_.block().task) : 0.0;
}

double Positioner::task_parameter() const noexcept {
  return blocks_.is_active() ? static_cast<double>(blocks_.block().parameter) : 0.0;
}

double Positioner::task_mode() const noexcept {
  return blocks_.is_active() ? static_cast<double>(blocks_.block().mode) : 0.0;
}

double Positioner::residual_distance() const noexcept {
  return has_target() ? travel_.goal().target - travel_.position() : 0.0;
}

/// r2683.2 and r2683.3: the setpoint stands, and where it was to go.
bool Positioner::follow_setpoint() noexcept {
  const bool fixed = travel_.is_still() && !travel_.is_pending() && !search_.is_active();
  if (!fixed || tracks_)
    setpoint_reached_ = false;
  else if (travel_.has_arrived() && !travel_.is_cut_off() && travel_.has_target() && !blocks_.flies())
    setpoint_reached_ = true;
  return fixed;
}

void Positioner::show_status() noexcept {
  status_1_ = word_1(follow_setpoint());
  status_2_ = word_2();
}

/// r2683 with @p fixed, the setpoint that stands.
std::uint16_t Positioner::word_1(bool fixed) const noexcept {
  const double velocity = travel_.velocity();
  const FixedStop& stop = blocks_.fixed_stop();
  return Word{}
      .bit(0, tracks_)
      .bit(1, travel_.is_capped())
      .bit(2, fixed)
      .bit(3, setpoint_reached_)
      .bit(4, velocity > 0.0)
      .bit(5, velocity < 0.0)
      .bit(6, messages_.stands(PositioningMessage::LimitMinusReached))
      .bit(7, messages_.stands(PositioningMessage::LimitPlusReached))
      .bit(10, (blocks_.outputs() & 1U) != 0)
      .bit(11, (blocks_.outputs() & 2U) != 0)
      .bit(12, stop.is_clamped())
      .bit(13, stop.has_torque())
      .bit(14, stop.is_active())
      .value();
}

std::uint16_t Positioner::word_2() const noexcept {
  const double change = travel_.acceleration() * travel_.velocity();
  return Word{}
      .bit(0, search_.is_active())
      .bit(1, flying_.is_active())
      .bit(2, search_.is_active() || flying_.is_active())
      .bit(3, flying_.is_outside())
      .bit(4, change > 0.0)
      .bit(5, change < 0.0)
      .bit(6, travel_.is_smoothing())
      .bit(7, flying_.corrects())
      .bit(9, modulo_range_ > 0.0)
      .bit(11, reference_.is_set)
      .bit(12, blocks_.acknowledges() || mdi_.acknowledges())
      .bit(13, stop_cams_.bars(Direction::Negative))
      .bit(14, stop_cams_.bars(Direction::Positive))
      .bit(15, has_task())
      .value();
}

}  // namespace drive
