#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "drive/positioning/blocks/block_mode.hpp"
#include "drive/positioning/modes/jog_mode.hpp"
#include "drive/positioning/modes/mdi_mode.hpp"
#include "drive/positioning/modes/mode_context.hpp"
#include "drive/positioning/modes/mode_switching.hpp"
#include "drive/positioning/positioner/stop_cams.hpp"
#include "drive/positioning/referencing/flying_referencing.hpp"
#include "drive/positioning/referencing/reference_search.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// What the basic positioner is told in a slice beside its inputs.
struct PositionerSlice {
  double highest_speed = 0.0;          ///< lower one of r1084 and r1087, of the motor (rad/s)
  double positioning_window = 0.0;     ///< p2544 (LU), 0 = off
  double monitoring_time = 0.0;        ///< p2545 (s)
  bool has_fault = false;              ///< a fault is active on the axis
  bool has_encoder_control = true;     ///< p1300 = 21
  bool is_ready_to_switch_on = false;  ///< the state in which p2577 is taken over
};

/// The basic positioner (EPOS): modes, references, limits and status words around one profile generator.
class Positioner {
 public:
  using Settings = PositionerSettings;
  using Inputs = PositionerInputs;
  static constexpr double kSlice = 1e-3;  ///< s

  /// @p is_present: the function module is there.
  explicit Positioner(bool is_present = false);

  /// A slice of kSlice, with the inputs as they are.
  void run(const PositionerSlice& slice) noexcept;
  /// Settings of blocks or limits have changed.
  void on_settings_changed() noexcept { blocks_changed_ = true; }
  /// Power-off: no input has come yet; the reference stays.
  void power_off() noexcept;
  /// The position is no longer known (encoder, overflow, other scaling): the reference is lost.
  void lose_reference() noexcept { reference_.is_set = false; }
  /// An absolute encoder is adjusted.
  void adopt_reference() noexcept { reference_.is_set = true; }

  // What it asks of the actual position in this slice.
  double moves_actual_by() const noexcept { return actual_moved_by_; }  ///< its coordinates (LU)
  /// By how much the coordinates of the setpoint have moved (LU).
  double moved_setpoint_by() const noexcept { return setpoint_moved_by_; }
  bool sets_actual() const noexcept { return sets_actual_; }  ///< the actual value becomes position()
  /// Whether a search runs, or did in the last slice: what it has asked for is its own until then.
  bool searches() const noexcept { return search_.is_active() || searched_; }
  bool search_has_failed() const noexcept { return search_.has_failed(); }
  bool is_flying() const noexcept { return flying_.is_active(); }
  bool awaits_mark() const noexcept { return search_.awaits_mark(); }
  bool awaits_probe() const noexcept { return flying_.awaits_probe(); }
  /// Modulo range in force (LU), 0 = none.
  double modulo_range() const noexcept { return modulo_range_; }
  /// Clamping torque (N·m) while it travels to a fixed stop or holds against one.
  bool limits_torque() const noexcept { return blocks_.fixed_stop().is_active(); }
  double torque_limit() const noexcept { return blocks_.fixed_stop().torque(); }

  double position() const noexcept;                                                    ///< r2665 (LU)
  double velocity() const noexcept { return travel_.velocity(); }                      ///< r2666 (LU/s)
  double mode_word() const noexcept;                                                   ///< r2669
  double block_word() const noexcept;                                                  ///< r2670
  double target() const noexcept;                                                      ///< r2671 (LU)
  double programmed_velocity() const noexcept;                                         ///< r2672 (LU/s)
  double acceleration_share() const noexcept;                                          ///< r2673
  double deceleration_share() const noexcept;                                          ///< r2674
  double task() const noexcept;                                                        ///< r2675
  double task_parameter() const noexcept;                                              ///< r2676
  double task_mode() const noexcept;                                                   ///< r2677
  double change_position() const noexcept { return blocks_.change_position(); }        ///< r2678 (LU)
  double cam_to_mark() const noexcept { return search_.cam_to_mark(); }                ///< r2680 (LU)
  double effective_override() const noexcept { return travel_.effective_override(); }  ///< r2681
  /// Whether a task has a target that is not endless.
  bool has_target() const noexcept;
  double residual_distance() const noexcept;                           ///< r2682 (LU)
  double correction() const noexcept { return flying_.difference(); }  ///< r2685 (LU)
  /// r2683 but for the bits that position control knows: 8, 9 and the cams.
  std::uint16_t status_1() const noexcept { return status_1_; }
  /// r2684 but for bits 8 (following error) and 10 (target reached).
  std::uint16_t status_2() const noexcept { return status_2_; }

  bool is_present() const noexcept { return is_present_; }
  PositionerMode mode() const noexcept;
  /// What leads the setpoint, in words: "MDI setting-up", "none".
  std::string_view mode_name() const noexcept;
  bool is_enabled() const noexcept { return enabled_; }
  bool tracks() const noexcept { return tracks_; }
  bool is_referenced() const noexcept { return reference_.is_set; }
  bool is_clamped() const noexcept { return blocks_.fixed_stop().is_clamped(); }
  const Travel& travel() const noexcept { return travel_; }
  const BlockMode& blocks() const noexcept { return blocks_; }
  const MdiMode& mdi() const noexcept { return mdi_; }
  const JogMode& jog() const noexcept { return jog_; }
  const StopCams& stop_cams() const noexcept { return stop_cams_; }
  /// Whether a task leads the setpoint (r2684.15).
  bool has_task() const noexcept;
  /// Whether the next slice with the same inputs can be left out while the pulses are off.
  bool is_settled() const noexcept { return settled_; }

  PositioningMessages& messages() noexcept { return messages_; }

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};
  Inputs inputs{};

 private:
  ModeContext context(const PositionerSlice& slice) noexcept;
  // Enable and tracking.
  void follow_enable(const PositionerSlice& slice, ModeContext& context) noexcept;
  void abandon() noexcept;
  bool tracks_now(const PositionerSlice& slice) const noexcept;
  // Limits (positioner_limits.cpp).
  void follow_modulo(const PositionerSlice& slice) noexcept;
  void bound(const PositionerSlice& slice) noexcept;
  void limit_jerk() noexcept;
  void watch_limits() noexcept;
  void watch_actual_position(const PositionerSlice& slice) noexcept;
  bool has_software_limits() const noexcept;
  void follow_blocks() noexcept;
  // Modes.
  void set_reference(ModeContext& context) noexcept;
  void correct(ModeContext& context) noexcept;
  bool block_is_requested(const ModeContext& context) const noexcept;
  bool mdi_is_requested(const ModeContext& context) noexcept;
  void choose_mode(ModeContext& context) noexcept;
  bool is_admitted(ModeContext& context, ModeRequest request, bool Inputs::*signal) noexcept;
  void begin(ModeContext& context, ModeRequest request, bool Inputs::*signal) noexcept;
  bool Inputs::*signal_of_mode() const noexcept;
  void run_mode(ModeContext& context) noexcept;
  void move(ModeContext& context, const PositionerSlice& slice) noexcept;
  void move_coordinates(double by, bool moves_actual) noexcept;
  void wrap() noexcept;
  // Status words (positioner_status.cpp).
  void show_status() noexcept;
  bool follow_setpoint() noexcept;
  std::uint16_t word_1(bool fixed) const noexcept;
  std::uint16_t word_2() const noexcept;

  bool is_present_;
  Travel travel_;
  PositioningMessages messages_;
  Refusals refusals_;
  ReferencePoint reference_;
  JogMode jog_;
  ReferenceSearch search_;
  FlyingReferencing flying_;
  BlockMode blocks_;
  MdiMode mdi_;
  StopCams stop_cams_;
  Inputs before_{};
  bool is_first_slice_ = true;
  bool enabled_ = false;
  bool was_enabled_ = false;  // since power-on, or since the position became valid
  bool tracks_ = true;
  bool settled_ = false;
  bool searched_ = false;  // when the slice began
  bool blocks_changed_ = true;
  bool sets_actual_ = false;
  bool corrects_next_ = false;  // p2512 takes the correction of the slice before
  bool setpoint_reached_ = false;
  std::array<bool, 2> beyond_reported_{};
  BlockLimits block_limits_{};
  double modulo_range_ = 0.0;
  double actual_moved_by_ = 0.0;    // in this slice
  double setpoint_moved_by_ = 0.0;  // in this slice
  std::uint16_t status_1_ = 0;
  std::uint16_t status_2_ = 0;
};

}  // namespace drive
