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
/// In this time a statusword follows a controlword.
constexpr canopen::Duration kPatience = std::chrono::milliseconds{100};
/// A reset may have been sent so long before a PDO has told the fault that EMCY has told already.
constexpr canopen::Duration kUnderWay = std::chrono::milliseconds{200};
/// What was read longer ago may be another value now.
constexpr canopen::Duration kFresh = std::chrono::seconds{1};
constexpr unsigned kMostResets = 3;

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

bool AxisCourse::is_of_shown_mode() const noexcept {
  return !shown_since_ || (statusword_ && statusword_->heard.place >= shown_since_->place);
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
      return take_statusword(value, scene);
    case object::kErrorCode:
      return look();
    case object::kMode:
      if (value.is_of_master()) take_mode(told, findings);
      return;
    case object::kModeDisplay:
      mode_unread_ = false;
      if (shown_mode_ && shown_mode_->value != told.value) shown_since_ = told.heard;
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
    const bool leads_on =
        (word.value & ~before & object::kEnableAll) != 0;  // nobody waits to stop, or with a reset
    if (!leads_on) return;
    findings.add(rules::kTooFast, node_, {controlword_->heard, word.heard}, words);
  } else if (object::is_switch_on_disabled(statusword_->value) && (word.value & object::kSwitchOn) != 0) {
    findings.add(rules::kStepSkipped, node_, {statusword_->heard, word.heard}, words);
  }
}

void AxisCourse::judge_reset(const DriveValue& value, Findings& findings) {
  const bool is_edge = rises(controlword_ ? controlword_->value : 0, value.value, object::kFaultReset);
  if (is_edge) edge_ = value.heard;
  if (!statusword_ || !object::is_fault(statusword_->value)) return;
  const Told word{value.value, value.heard};
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
  if (rises(word.value, before, object::kNewSetPoint)) let_go_ = word.heard;
  if (!rises(before, word.value, object::kNewSetPoint)) return;
  unstarted_.reset();
  const auto target = targets_.find(object::kTargetPosition);
  const bool is_absolute = is_in(object::kProfilePosition) && (word.value & object::kRelative) == 0;
  if (is_absolute && target != targets_.end()) judge_limits(target->second, findings);
  const bool is_old = let_go_ && word.heard.at - let_go_->at >= kPatience;  // bit 12 will have followed since
  if (!is_in(object::kProfilePosition) || !is_enabled() || (statusword_->value & object::kSetPointTaken) == 0 ||
      is_old || !is_of_shown_mode())
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
  if (!is_in(object::kCyclicPosition) || target == targets_.end()) return;
  judge_limits(target->second, findings);
  if (!actual_ || !window_) return;
  if (word.heard.at - actual_->heard.at > kFresh) return;
  const std::int64_t way = object::difference(target->second.value, actual_->value);
  if (window_->value > 0 && std::llabs(way) > window_->value)
    findings.add(rules::kStartJump, node_, {actual_->heard, target->second.heard, word.heard},
                 [&] { return name(fmt::format("{} increments, 6065h has {}", way, window_->value).c_str()); });
}

void AxisCourse::take_statusword(const DriveValue& value, const Scene& scene) {
  const Told word{value.value, value.heard};
  status_since_command_ = true;
  is_by_pdo_ = value.way == DriveValue::Way::Tpdo;
  let_go_.reset();
  const std::string_view state = object::state_in(word.value);
  if (!statusword_ || object::state_in(statusword_->value) != state)
    scene.time_lines[node_].add(word.heard, name(std::string{state}.c_str()));
  const bool was_fault = statusword_ && object::is_fault(statusword_->value);
  if (object::is_fault(word.value) && !was_fault) {
    reset_rose_ = is_by_pdo_ && edge_ && word.heard.at - edge_->at < kUnderWay;
    reset_said_ = has_looked_ = false;
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
  const bool is_known =
      is_of_shown_mode() && (is_by_pdo_ || (statusword_ && mode.heard.at - statusword_->heard.at < kFresh));
  const bool moves =
      is_known && is_enabled() && shown_mode_ && object::moves(shown_mode_->value, statusword_->value);
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

}  // namespace audit
