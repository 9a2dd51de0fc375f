#include "audit/drive/axis_course.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "audit/drive/drive_objects.hpp"
#include "audit/drive/drive_rules.hpp"

namespace audit {

namespace rules = drive_rules;
namespace object = drive_object;

namespace {

constexpr canopen::Duration kOneWay = std::chrono::seconds{1};
/// A fault that an RPDO has not had time to be noticed in: bit 7 in it may be that of the fault before.
constexpr canopen::Duration kTimeToNotice = std::chrono::seconds{1};
constexpr canopen::Duration kPatience = std::chrono::milliseconds{100};
/// A position that was read longer ago may be another one now.
constexpr canopen::Duration kFresh = std::chrono::seconds{1};
constexpr unsigned kMostResets = 3;
constexpr unsigned kMostHalted = 5;
constexpr unsigned kSureCycles = 3;

/// @p to - @p from of positions that overflow (32 bits).
constexpr std::int64_t difference(std::int64_t to, std::int64_t from) noexcept {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
}

bool rises(std::int64_t before, std::int64_t now, std::uint16_t bit) noexcept {
  return (before & bit) == 0 && (now & bit) != 0;
}

}  // namespace

std::string AxisCourse::name(const char* what) const {
  return axis_ == 0 ? std::string{what} : fmt::format("axis {}: {}", axis_ + 1, what);
}

bool AxisCourse::is_enabled() const noexcept {
  return statusword_ && object::is_enabled(statusword_->value);
}

void AxisCourse::take(const DriveValue& value, const Scene& scene) {
  Findings& findings = scene.findings;
  node_ = value.node;
  axis_ = value.axis;
  const Told told{value.value, value.heard};
  switch (value.object) {
    case object::kControlword:
      if (value.is_of_master()) take_controlword(value, findings);
      return;
    case object::kStatusword:
      return take_statusword(told, scene);
    case object::kErrorCode:
      return look();
    case object::kMode:
      if (value.is_of_master()) take_mode(told, findings);
      return;
    case object::kModeDisplay:
      mode_unread_ = false;
      shown_mode_ = told;
      return;
    case object::kActualPosition:
      actual_ = told;
      return;
    case object::kFollowingErrorWindow:
      window_ = told;
      return;
    case object::kSupportedModes:
      modes_ = told;
      return;
    case object::kPositionLimits:
      (value.sub_index == 1 ? low_limit_ : high_limit_) = told;
      return;
    default:
      if (value.is_of_master()) take_target(value, findings);
  }
}

void AxisCourse::take_controlword(const DriveValue& value, Findings& findings) {
  const Told word{value.value, value.heard};
  if (value.way == DriveValue::Way::Rpdo) {
    by_rpdo_ = value.heard;
  } else if (has_times_ && by_rpdo_ && value.heard.at - by_rpdo_->at < kOneWay) {
    return findings.add(rules::kTwoSources, node_, {*by_rpdo_, value.heard}, [&] { return name("controlword"); });
  }
  const std::int64_t before = controlword_ ? controlword_->value : 0;
  judge_reset(value, findings);
  if (!controlword_ || before != word.value) {
    judge_command(word, findings);
    judge_set_point_bit(word, findings);
    const bool is_enabling = (word.value & object::kEnableAll) == object::kEnableAll &&
                             (before & object::kEnableAll) != object::kEnableAll;
    if (is_enabling) judge_enabling(word, findings);
  }
  if (((before ^ word.value) & object::kCommandBits) != 0)
    status_since_command_ = statusword_ && object::is_led_to(word.value, statusword_->value);
  controlword_ = word;
}

/// A controlword that is another one than before.
void AxisCourse::judge_command(const Told& word, Findings& findings) {
  const std::int64_t before = controlword_ ? controlword_->value : 0;
  if (!statusword_ || ((before ^ word.value) & object::kCommandBits) == 0) return;
  const auto words = [&] {
    return name(fmt::format("controlword {:04X}h, statusword {:04X}h", word.value, statusword_->value).c_str());
  };
  if (!status_since_command_) {
    const bool only_clears = (word.value & ~before & object::kCommandBits) == 0;  // nobody waits to stop
    if (only_clears) return;
    findings.add(rules::kTooFast, node_, {controlword_->heard, word.heard}, words);
  } else if (object::is_switch_on_disabled(statusword_->value) && (word.value & object::kSwitchOn) != 0) {
    findings.add(rules::kStepSkipped, node_, {statusword_->heard, word.heard}, words);
  }
}

void AxisCourse::judge_reset(const DriveValue& value, Findings& findings) {
  if (!statusword_ || !object::is_fault(statusword_->value)) return;
  const Told word{value.value, value.heard};
  const bool is_edge = rises(controlword_ ? controlword_->value : 0, word.value, object::kFaultReset);
  reset_rose_ = reset_rose_ || is_edge;
  if (is_edge) ++resets_;
  if (reset_said_ || (word.value & object::kFaultReset) == 0) return;
  if (!reset_rose_) {
    const bool is_cyclic = value.way == DriveValue::Way::Rpdo;
    if (is_cyclic && fault_ && word.heard.at - fault_->at < kTimeToNotice) return;
    reset_said_ = true;
    findings.add(rules::kResetWithoutEdge, node_,
                 {controlword_.value_or(word).heard, statusword_->heard, word.heard},
                 [&] { return name(fmt::format("statusword {:04X}h", statusword_->value).c_str()); });
  } else if (resets_ >= kMostResets && !has_looked_) {
    reset_said_ = true;
    findings.add(rules::kResetRepeated, node_, {statusword_->heard, word.heard},
                 [&] { return name(fmt::format("{} times", resets_).c_str()); });
  }
}

void AxisCourse::judge_set_point_bit(const Told& word, Findings& findings) {
  const std::int64_t before = controlword_ ? controlword_->value : 0;
  if (!rises(before, word.value, object::kNewSetPoint)) return;
  unstarted_.reset();
  const auto target = targets_.find(object::kTargetPosition);
  const bool is_absolute = is_in(object::kProfilePosition) && (word.value & object::kRelative) == 0;
  if (is_absolute && target != targets_.end()) judge_limits(target->second, findings);
  if (!is_in(object::kProfilePosition) || !is_enabled() || (statusword_->value & object::kSetPointTaken) == 0)
    return;
  findings.add(rules::kHandshake, node_, {statusword_->heard, word.heard},
               [&] { return name(fmt::format("statusword {:04X}h", statusword_->value).c_str()); });
}

void AxisCourse::judge_enabling(const Told& word, Findings& findings) {
  if (mode_unread_ && mode_) {
    mode_unread_ = false;
    findings.add(rules::kModeUnread, node_, {mode_->heard, word.heard},
                 [&] { return name(fmt::format("mode {}", mode_->value).c_str()); });
  }
  const auto target = targets_.find(object::kTargetPosition);
  if (!is_in(object::kCyclicPosition) || target == targets_.end() || !actual_ || !window_) return;
  if (word.heard.at - actual_->heard.at > kFresh) return;
  const std::int64_t way = difference(target->second.value, actual_->value);
  if (window_->value > 0 && std::llabs(way) > window_->value)
    findings.add(rules::kStartJump, node_, {actual_->heard, target->second.heard, word.heard},
                 [&] { return name(fmt::format("{} increments, 6065h has {}", way, window_->value).c_str()); });
}

void AxisCourse::take_statusword(const Told& word, const Scene& scene) {
  status_since_command_ = true;
  const std::string_view state = object::state_in(word.value);
  if (!statusword_ || object::state_in(statusword_->value) != state)
    scene.time_lines[node_].add(word.heard, name(std::string{state}.c_str()));
  const bool was_fault = statusword_ && object::is_fault(statusword_->value);
  if (object::is_fault(word.value) && !was_fault) {
    reset_rose_ = reset_said_ = has_looked_ = false;
    resets_ = 0;
    fault_ = word.heard;
  }
  statusword_ = word;
}

void AxisCourse::take_mode(const Told& mode, Findings& findings) {
  const bool is_other = !mode_ || mode_->value != mode.value;
  mode_ = mode;
  if (!is_other) return;
  mode_unread_ = true;
  if (!judge_support(mode, findings)) return;
  const bool moves = is_enabled() && shown_mode_ && object::moves(shown_mode_->value, statusword_->value);
  if (moves && shown_mode_->value != mode.value)
    findings.add(rules::kModeMoving, node_, {statusword_->heard, mode.heard},
                 [&] { return name(fmt::format("mode {}", mode.value).c_str()); });
}

/// Whether the drive has @p mode, as far as that is known.
bool AxisCourse::judge_support(const Told& mode, Findings& findings) const {
  const bool is_standard = mode.value > 0 && mode.value <= 32;
  if (!modes_ || !is_standard || (modes_->value >> (mode.value - 1) & 1) != 0) return true;
  findings.add(rules::kModeUnsupported, node_, {modes_->heard, mode.heard},
               [&] { return name(fmt::format("mode {}", mode.value).c_str()); });
  return false;
}

void AxisCourse::take_refused(const DriveValue& value, Findings& findings) const {
  const Told told{value.value, value.heard};
  if (value.object == object::kMode) (void)judge_support(told, findings);
  if (value.object == object::kTargetPosition) judge_limits(told, findings);
}

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
  if (!is_in(object::kProfilePosition)) return judge_limits(target, findings);
  if (!is_enabled()) return;
  if (unstarted_ && target.heard.at - unstarted_->heard.at >= kPatience)
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
  const std::int64_t step = difference(target.value, before.value);
  const std::int64_t last = step_.value_or(0);
  const bool is_jump = window_ && window_->value > 0 && std::llabs(difference(step, last)) > window_->value;
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
