#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "audit/base/topic.hpp"
#include "audit/drive/drive_values.hpp"

namespace audit {

/// What a master does with one axis.
class AxisCourse {
 public:
  /// @p has_times: frames have times.
  explicit AxisCourse(bool has_times) : has_times_{has_times} {}

  /// Takes a value of the axis.
  void take(const DriveValue& value, const Scene& scene);
  /// A value of the axis is to be written, and the drive refuses it.
  void take_refused(const DriveValue& value, Findings& findings) const;
  /// A SYNC comes.
  void take_sync(const Heard& heard);
  /// Its node gets another NMT state: who has sent PDOs may begin anew over SDO.
  void leave_pdos() noexcept { by_rpdo_.reset(); }
  /// The cause of an error of the node is looked at.
  void look() noexcept { has_looked_ = true; }

 private:
  /// A value with the frame that has told it.
  struct Told {
    std::int64_t value = 0;
    Heard heard{};
  };
  using Known = std::optional<Told>;

  void take_controlword(const DriveValue& value, Findings& findings);
  void judge_command(const Told& word, Findings& findings);
  void judge_reset(const DriveValue& value, Findings& findings);
  void judge_set_point_bit(const Told& word, Findings& findings);
  void judge_enabling(const Told& word, Findings& findings);
  void take_statusword(const DriveValue& value, const Scene& scene);
  bool judge_support(const Told& mode, Findings& findings) const;
  void judge_limits(const Told& target, Findings& findings) const;
  void judge_step(const Told& target, const Told& before, Findings& findings);
  void judge_gap(const Told& target, const Told& before, Findings& findings);
  void take_mode(const Told& mode, Findings& findings);
  void take_target(const DriveValue& value, Findings& findings);
  void judge_target(const Told& target, std::uint16_t index, Findings& findings);
  void judge_position(const Told& target, Findings& findings);
  [[nodiscard]] bool is_in(std::int64_t mode) const noexcept { return shown_mode_ && shown_mode_->value == mode; }
  [[nodiscard]] bool is_enabled() const noexcept;
  [[nodiscard]] bool is_cyclic() const noexcept;
  /// Whether the bits of the statusword that depend on the mode are those of the mode that is shown.
  [[nodiscard]] bool is_of_shown_mode() const noexcept;
  [[nodiscard]] std::string name(const char* what) const;

  bool has_times_;
  std::uint8_t node_ = 0, axis_ = 0;
  Known controlword_, statusword_, mode_, shown_mode_, actual_, window_, low_limit_, high_limit_, modes_;
  std::map<std::uint16_t, Told> targets_;
  std::optional<Heard> by_rpdo_;      ///< the last controlword that an RPDO has brought
  bool status_since_command_ = true;  ///< a statusword has come since the controlword changed
  bool is_by_pdo_ = false;            ///< the statusword: it tells when it becomes another one
  std::optional<Heard> shown_since_;  ///< what has told that the shown mode has become another one
  bool mode_unread_ = false;          ///< the mode was written, and not read since
  std::optional<Heard> let_go_;       ///< the controlword that has cleared bit 4, until a statusword comes
  std::optional<Heard> edge_;         ///< the last controlword in which bit 7 has risen
  std::optional<Heard> fault_;        ///< the statusword that has told the fault
  bool reset_rose_ = false;           ///< bit 7 has risen since the fault
  bool has_looked_ = false;           ///< at the cause of the fault
  bool reset_said_ = false;           ///< that a reset is of no use, for this fault
  unsigned resets_ = 0;               ///< in this fault
  unsigned halted_ = 0;               ///< set-points that have changed while halt was set
  std::optional<Told> unstarted_;     ///< a position that bit 4 has not followed
  unsigned cycles_ = 0;               ///< SYNC in a row that had a set-point, or a few before missed_
  bool has_set_point_ = false;        ///< since the last SYNC
  std::optional<Heard> missed_;       ///< the last SYNC, which had no set-point
  std::optional<std::int64_t> step_;  ///< between the last two set-points of csp
};

}  // namespace audit
