// AxisCourse: set-points and the positions that they lead to.
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "audit/drive/axis_course.hpp"
#include "audit/drive/drive_objects.hpp"
#include "audit/drive/drive_rules.hpp"

namespace audit {

namespace rules = drive_rules;
namespace object = drive_object;

namespace {

constexpr unsigned kMostHalted = 5;
constexpr unsigned kSureCycles = 3;
/// A position that was not gone to for so long is not part of a command.
constexpr canopen::Duration kPause = std::chrono::milliseconds{100};

}  // namespace

void AxisCourse::take_target(const DriveValue& value, Findings& findings) {
  const Told target{value.value, value.heard};
  if (value.object == object::kTargetPosition && value.way == DriveValue::Way::Rpdo) has_set_point_ = true;
  const auto [before, is_new] = targets_.try_emplace(value.object, target);
  if (!is_new && before->second.value == target.value) {
    missed_.reset();
    if (value.object == object::kTargetPosition) step_ = 0;
    return;
  }
  judge_target(target, value.object, findings);
  if (value.object == object::kTargetPosition && value.way == DriveValue::Way::Rpdo && !is_new) {
    judge_gap(target, before->second, findings);
    judge_step(target, before->second, findings);
  }
  before->second = target;
}

/// A set-point that is another one than before.
void AxisCourse::judge_target(const Told& target, std::uint16_t index, Findings& findings) {
  const bool is_halted = controlword_ && (controlword_->value & object::kHalt) != 0 && is_enabled();
  halted_ = is_halted ? halted_ + 1 : 0;
  if (halted_ == kMostHalted)
    findings.add(rules::kHalt, node_, {controlword_->heard, target.heard},
                 [&] { return name(fmt::format("{:04X}h has changed {} times", index, halted_).c_str()); });
  if (index == object::kTargetPosition) judge_position(target, findings);
}

void AxisCourse::judge_limits(const Told& target, Findings& findings) const {
  const std::int64_t low = low_limit_ ? low_limit_->value : 0, high = high_limit_ ? high_limit_->value : 0;
  const bool has_limits = low != 0 || high != 0;
  const bool is_beyond = (high_limit_ && target.value > high) || (low_limit_ && target.value < low);
  if (has_limits && is_beyond)
    findings.add(rules::kBeyondLimits, node_, {target.heard},
                 [&] { return name(fmt::format("{}, 607Dh has {} to {}", target.value, low, high).c_str()); });
}

void AxisCourse::judge_position(const Told& target, Findings& findings) {
  if (!is_in(
          object::kProfilePosition)) {  // in other modes it means nothing, nor in csp while the axis is disabled
    if (!shown_mode_ || is_cyclic()) judge_limits(target, findings);
    return;
  }
  if (!is_enabled()) return;
  if (unstarted_ && target.heard.at - unstarted_->heard.at >= kPause)
    findings.add(rules::kNoNewSetPoint, node_, {unstarted_->heard, target.heard},
                 [&] { return name(fmt::format("{} was not gone to", unstarted_->value).c_str()); });
  unstarted_ = target;
}

bool AxisCourse::is_cyclic() const noexcept {
  return is_in(object::kCyclicPosition) && is_enabled();
}

/// A movement that goes on behind a SYNC without a set-point has stood still for it.
void AxisCourse::judge_gap(const Told& target, const Told& before, Findings& findings) {
  const auto missed = std::exchange(missed_, std::nullopt);
  if (!missed || !is_cyclic() || step_.value_or(0) == 0) return;
  findings.add(rules::kSetPointMissing, node_, {before.heard, *missed, target.heard},
               [&] { return name("607Ah"); });
}

/// A set-point that is far from where the last ones lead to.
void AxisCourse::judge_step(const Told& target, const Told& before, Findings& findings) {
  const std::int64_t step = object::difference(target.value, before.value);
  const std::int64_t last = step_.value_or(0);
  const bool is_jump =
      window_ && window_->value > 0 && std::llabs(object::difference(step, last)) > window_->value;
  if (is_cyclic() && step_ && is_jump)
    findings.add(rules::kJump, node_, {before.heard, target.heard}, [&] {
      return name(fmt::format("{} increments, {} before, 6065h has {}", step, last, window_->value).c_str());
    });
  step_ = step;
}

void AxisCourse::take_sync(const Heard& heard) {
  const bool had = std::exchange(has_set_point_, false);
  if (!is_cyclic()) {
    cycles_ = 0;
    missed_.reset();
    step_.reset();
  } else if (had) {
    ++cycles_;
  } else {
    if (cycles_ >= kSureCycles) missed_ = heard;
    cycles_ = 0;
  }
}

}  // namespace audit
