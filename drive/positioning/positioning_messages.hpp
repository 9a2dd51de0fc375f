#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace drive {

/// The messages of positioning.
enum class PositioningMessage : std::uint8_t {
  JerkTimeLimited,
  SaveAdjustment,
  ModuloDoesNotFit,
  ReferenceOutOfRange,
  StandstillMonitoring,
  PositionMonitoring,
  FollowingError,
  EncoderFault,
  NoEncoder,
  MaximumVelocityLimited,
  VelocityLimited,
  IllegalSignals,
  CamNotFound,
  MarkNotFound,
  EndOfCamNotFound,
  NotReferenced,
  NoSuchBlock,
  ChangeNotRequested,
  BlockInconsistent,
  NoSubsequentBlock,
  BlockNumberTwice,
  IllegalTaskParameter,
  NoJumpDestination,
  BlockBelowLimit,
  BlockAboveLimit,
  BlockOutsideModulo,
  BlockNeedsModulo,
  BeginningOfRange,
  EndOfRange,
  TargetBelowRange,
  TargetAboveRange,
  TargetBelowLimit,
  TargetAboveLimit,
  LimitMinusReached,
  LimitPlusReached,
  BelowLimitMinus,
  AboveLimitPlus,
  ClampingTorqueNotReached,
  FixedStopLeft,
  FixedStopNotReached,
  IntermediateStopMissing,
  RejectMissing,
  RelativeNotPossible,
  CorrectionOutsideWindow,
  EnableWithdrawn,
  StopCamMinus,
  StopCamPlus,
  PositionOverflow,
  ReferenceInterrupted,
  EnableNotPossible,
  SettingValueActive,
  ProbeNotPossible,
  ReversingCamWrongSide,
  StopCamWrongSide,
  FixedStopNotPossible,
  ReferenceOutsideRange,
  Encoder1ProbeNotPossible,
  Encoder1Fault,
  Encoder1SettingValueActive,
  Encoder1Missing,
  Encoder1Overflow,
  Encoder1Interrupted,
};

/// Whether a message comes once, when its cause does, or stands as long as its cause.
enum class Comes : std::uint8_t { Once, WhileCauseStands };

struct PositioningMessageRow {
  PositioningMessage message;
  std::uint16_t number;
  Comes comes;
};

/// One row a message, in the order of the enumeration; what each is, says the table of faults and alarms.
inline constexpr std::array kPositioningMessages = [] {
  using enum PositioningMessage;
  using enum Comes;
  return std::array{
      PositioningMessageRow{JerkTimeLimited, 7440, WhileCauseStands},
      PositioningMessageRow{SaveAdjustment, 7441, WhileCauseStands},
      PositioningMessageRow{ModuloDoesNotFit, 7442, Once},
      PositioningMessageRow{ReferenceOutOfRange, 7443, Once},
      PositioningMessageRow{StandstillMonitoring, 7450, Once},
      PositioningMessageRow{PositionMonitoring, 7451, Once},
      PositioningMessageRow{FollowingError, 7452, Once},
      PositioningMessageRow{EncoderFault, 7453, Once},
      PositioningMessageRow{NoEncoder, 7454, WhileCauseStands},
      PositioningMessageRow{MaximumVelocityLimited, 7455, WhileCauseStands},
      PositioningMessageRow{VelocityLimited, 7456, WhileCauseStands},
      PositioningMessageRow{IllegalSignals, 7457, WhileCauseStands},
      PositioningMessageRow{CamNotFound, 7458, Once},
      PositioningMessageRow{MarkNotFound, 7459, Once},
      PositioningMessageRow{EndOfCamNotFound, 7460, Once},
      PositioningMessageRow{NotReferenced, 7461, WhileCauseStands},
      PositioningMessageRow{NoSuchBlock, 7462, WhileCauseStands},
      PositioningMessageRow{ChangeNotRequested, 7463, WhileCauseStands},
      PositioningMessageRow{BlockInconsistent, 7464, Once},
      PositioningMessageRow{NoSubsequentBlock, 7465, WhileCauseStands},
      PositioningMessageRow{BlockNumberTwice, 7466, WhileCauseStands},
      PositioningMessageRow{IllegalTaskParameter, 7467, WhileCauseStands},
      PositioningMessageRow{NoJumpDestination, 7468, WhileCauseStands},
      PositioningMessageRow{BlockBelowLimit, 7469, WhileCauseStands},
      PositioningMessageRow{BlockAboveLimit, 7470, WhileCauseStands},
      PositioningMessageRow{BlockOutsideModulo, 7471, WhileCauseStands},
      PositioningMessageRow{BlockNeedsModulo, 7472, WhileCauseStands},
      PositioningMessageRow{BeginningOfRange, 7473, WhileCauseStands},
      PositioningMessageRow{EndOfRange, 7474, WhileCauseStands},
      PositioningMessageRow{TargetBelowRange, 7475, Once},
      PositioningMessageRow{TargetAboveRange, 7476, Once},
      PositioningMessageRow{TargetBelowLimit, 7477, WhileCauseStands},
      PositioningMessageRow{TargetAboveLimit, 7478, WhileCauseStands},
      PositioningMessageRow{LimitMinusReached, 7479, WhileCauseStands},
      PositioningMessageRow{LimitPlusReached, 7480, WhileCauseStands},
      PositioningMessageRow{BelowLimitMinus, 7481, Once},
      PositioningMessageRow{AboveLimitPlus, 7482, Once},
      PositioningMessageRow{ClampingTorqueNotReached, 7483, WhileCauseStands},
      PositioningMessageRow{FixedStopLeft, 7484, Once},
      PositioningMessageRow{FixedStopNotReached, 7485, Once},
      PositioningMessageRow{IntermediateStopMissing, 7486, WhileCauseStands},
      PositioningMessageRow{RejectMissing, 7487, WhileCauseStands},
      PositioningMessageRow{RelativeNotPossible, 7488, Once},
      PositioningMessageRow{CorrectionOutsideWindow, 7489, WhileCauseStands},
      PositioningMessageRow{EnableWithdrawn, 7490, Once},
      PositioningMessageRow{StopCamMinus, 7491, Once},
      PositioningMessageRow{StopCamPlus, 7492, Once},
      PositioningMessageRow{PositionOverflow, 7493, Once},
      PositioningMessageRow{ReferenceInterrupted, 7495, WhileCauseStands},
      PositioningMessageRow{EnableNotPossible, 7496, WhileCauseStands},
      PositioningMessageRow{SettingValueActive, 7497, WhileCauseStands},
      PositioningMessageRow{ProbeNotPossible, 7498, WhileCauseStands},
      PositioningMessageRow{ReversingCamWrongSide, 7499, Once},
      PositioningMessageRow{StopCamWrongSide, 7503, Once},
      PositioningMessageRow{FixedStopNotPossible, 7505, WhileCauseStands},
      PositioningMessageRow{ReferenceOutsideRange, 7557, WhileCauseStands},
      PositioningMessageRow{Encoder1ProbeNotPossible, 7577, WhileCauseStands},
      PositioningMessageRow{Encoder1Fault, 7581, WhileCauseStands},
      PositioningMessageRow{Encoder1SettingValueActive, 7584, WhileCauseStands},
      PositioningMessageRow{Encoder1Missing, 7587, WhileCauseStands},
      PositioningMessageRow{Encoder1Overflow, 7593, WhileCauseStands},
      PositioningMessageRow{Encoder1Interrupted, 7596, WhileCauseStands},
  };
}();
static_assert([] {
  for (std::size_t i = 0; i < kPositioningMessages.size(); ++i)
    if (kPositioningMessages[i].message != static_cast<PositioningMessage>(i)) return false;
  return true;
}());

/// The messages of positioning on their way to the drive object, which is told once a process-data cycle. What
/// has come and gone within one is told for that cycle.
class PositioningMessages {
 public:
  /// A message that comes once, with its value.
  void raise(PositioningMessage message, std::uint32_t value = 0) noexcept {
    seen_ |= bit(message);
    values_[place(message)] = value;
  }
  /// Whether the cause of @p message stands, and with which value.
  void show(PositioningMessage message, bool stands, std::uint32_t value = 0) noexcept {
    if (!stands) {
      standing_ &= ~bit(message);
      return;
    }
    if (!this->stands(message) || values_[place(message)] != value) raise(message, value);
    standing_ |= bit(message);
  }
  /// A message that comes once, each time @p cause begins to hold.
  void fault_once(PositioningMessage message, bool cause, std::uint32_t value = 0) noexcept {
    if (cause && (held_ & bit(message)) == 0) raise(message, value);
    held_ = cause ? held_ | bit(message) : held_ & ~bit(message);
  }
  bool stands(PositioningMessage message) const noexcept { return (standing_ & bit(message)) != 0; }
  /// Whether there is something to tell.
  bool has_news() const noexcept { return seen_ != 0 || standing_ != told_; }
  /// Whether one that comes once has come and was not told yet.
  bool has_fault() const noexcept { return (seen_ & kOnce) != 0; }

  /// Calls @p tell(row, present, value) for each message that has come or is gone since the last call.
  template <class Tell>
  void tell(const Tell& tell) noexcept {
    const Mask present = seen_ | standing_;
    const Mask concerned = seen_ | (present ^ told_);
    told_ = present & ~kOnce;
    seen_ = 0;
    for (const PositioningMessageRow& row : kPositioningMessages)
      if ((concerned & bit(row.message)) != 0)
        tell(row, (present & bit(row.message)) != 0, values_[place(row.message)]);
  }
  /// Power-off: nothing has come.
  void clear() noexcept { seen_ = standing_ = told_ = held_ = 0; }

 private:
  using Mask = std::uint64_t;
  static_assert(kPositioningMessages.size() <= 64, "a bit a message");
  static constexpr std::size_t place(PositioningMessage message) noexcept {
    return static_cast<std::size_t>(message);
  }
  static constexpr Mask bit(PositioningMessage message) noexcept { return Mask{1} << place(message); }
  static constexpr Mask kOnce = [] {
    Mask once = 0;
    for (const PositioningMessageRow& row : kPositioningMessages)
      if (row.comes == Comes::Once) once |= Mask{1} << static_cast<std::size_t>(row.message);
    return once;
  }();

  Mask seen_ = 0;      // since the last tell()
  Mask standing_ = 0;  // now
  Mask held_ = 0;      // causes of fault_once()
  Mask told_ = 0;      // as present, by the last tell()
  std::array<std::uint32_t, kPositioningMessages.size()> values_{};
};

}  // namespace drive
