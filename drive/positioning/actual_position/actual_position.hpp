#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/base/input_edges.hpp"
#include "drive/positioning/actual_position/backlash.hpp"
#include "drive/positioning/actual_position/length_scale.hpp"
#include "drive/positioning/actual_position/position_capture.hpp"
#include "drive/positioning/actual_position/position_channel.hpp"
#include "motor/data/machine_data.hpp"

namespace drive {

/// Position of the load from what the encoder has counted: scaled to length units (LU), with its offsets and
/// corrections, backlash and modulo range; and its value at zero marks and probes. Index 0 of what has four is
/// that of the position control, 1 to 3 belong to an encoder. Runs a slice at a time.
class ActualPosition {
 public:
  static constexpr std::size_t kEncoders = 3;
  static constexpr std::size_t kValues = 1 + kEncoders;
  /// Values of p2507.
  static constexpr std::int32_t kNotAdjusted = 1;
  static constexpr std::int32_t kStartAdjustment = 2;
  static constexpr std::int32_t kAdjusted = 3;
  /// The range of coordinates that can be set (LU).
  static constexpr std::int64_t kLowestCoordinate = -2147482648;
  static constexpr std::int64_t kHighestCoordinate = 2147482647;

  struct Settings {
    using Block = ActualPosition;
    using Terminals = std::array<std::int32_t, kEncoders>;  ///< n is DI n-1, 0 none

    std::int32_t encoder = 1;             ///< p2502
    double units_per_10_mm = 10000.0;     ///< p2503, of a linear encoder, which no axis has
    std::int32_t gear_motor = 1;          ///< p2504
    std::int32_t gear_load = 1;           ///< p2505
    std::int32_t units_per_load = 10000;  ///< p2506
    std::int32_t adjustment = 1;          ///< p2507
    Terminals probe_terminal_1{};         ///< p0488
    Terminals probe_terminal_2{};         ///< p0489
    Terminals mark_selection{};           ///< p0493
    Terminals equivalent_mark{};          ///< p0494
    Terminals equivalent_mark_2{};        ///< p0495, where p0494 is 0
    std::int32_t direct_probe_1 = 0;      ///< p2517
    std::int32_t direct_probe_2 = 0;      ///< p2518
    double adjustment_offset = 0.0;       ///< p2525 (LU), 0..2^32-1; from 2^31 on it is negative, less 2^32
    std::int32_t backlash = 0;            ///< p2583 (LU)
  };
  struct Inputs {
    using Block = ActualPosition;
    using Bits = std::array<bool, kValues>;
    using Values = std::array<double, kValues>;

    Bits search_mark{};         ///< p2508
    Bits evaluate_probe{};      ///< p2509
    Bits second_probe{};        ///< p2510
    Bits falling_edge{};        ///< p2511
    Bits correct{};             ///< p2512
    Bits set_position{};        ///< p2514
    Bits correct_negatively{};  ///< p2730
    Values correction{};        ///< p2513 (LU)
    Values setting_value{};     ///< p2515 (LU)
    Values offset{};            ///< p2516 (LU)

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// A slice of time begins; what is told of the one that has passed belongs to it.
  struct Slice {
    std::int64_t counts = 0;            ///< of the encoder, since the unit was made
    double speed = 0.0;                 ///< of the encoder (rad/s)
    bool encoder_faulty = false;        ///< a fault of the encoder is active
    InputEdges inputs{};                ///< of the slice that has passed
    double reference_coordinate = 0.0;  ///< p2598[0] (LU), which an adjustment takes
    bool is_referenced = false;         ///< r2684.11
    bool holds_mark = false;            ///< p2508[0] waits: the positioner has it on and does not want a mark now
    bool holds_probe = false;           ///< p2509[0] waits
    bool holds_adjustment = false;      ///< p2507 = 2 waits
    bool asks_probe = false;            ///< the positioner wants a probe without p2509
    std::int64_t modulo_range = 0;      ///< p2576 (LU) while the axis is a modulo axis, otherwise 0
    std::optional<double> setpoint{};   ///< of a position that is controlled, 0..p2576-1 on a modulo axis (LU)
  };

  /// Of @p encoder, which has turned nowhere yet.
  explicit ActualPosition(const motor::EncoderData& encoder) noexcept;

  /// Power-on with the encoder at @p counts: an incremental one begins at 0, an absolute one where it is within
  /// the revolutions that it tells apart (p0421).
  void power_on(std::int64_t counts) noexcept;
  /// A process-data cycle begins: what was told of the last one for its messages alone is over.
  void begin_cycle() noexcept;
  void run(const Slice& slice) noexcept;

  /// The position becomes @p value (LU) where the axis is. False: that is outside the range of coordinates or of
  /// the modulo axis, and nothing is set.
  [[nodiscard]] bool set_position(std::int64_t value) noexcept;
  /// The position becomes greater by @p by (LU).
  void correct(std::int64_t by) noexcept { own().shift(by); }
  /// Takes whole modulo ranges out of the position: with a @p setpoint it becomes the one that is nearest to it,
  /// without one it is 0 to p2576-1. The slice does so by itself.
  void wrap(std::optional<double> setpoint) noexcept;
  /// What is known of the place of the load is no longer true: the reference is lost with the next slice, and an
  /// absolute encoder has to be adjusted anew.
  void invalidate() noexcept;
  /// The parameters were saved, p2525 with them.
  void on_saved() noexcept { unsaved_ = false; }

  /// LU, exact to the increment.
  double position() const noexcept { return static_cast<double>(whole()) + sensed_.rest; }
  /// r2521[0]: the same in whole LU, at the ends of the 32-bit range if it is beyond.
  std::int64_t shown() const noexcept;
  /// r2521, LU: [0] the position, [1] that of encoder 1, which is on the modulo range too, but has
  /// neither adjustment nor backlash.
  double shown_of(std::size_t index) const noexcept;
  /// r2521, LU: the same exactly, for what is connected to it.
  double position_of(std::size_t index) const noexcept;
  /// Without position control nothing runs: the encoder is at @p counts and turns with @p speed (rad/s).
  void note(std::int64_t counts, double speed) noexcept {
    counts_ = counts;
    noted_speed_ = speed;
  }
  /// LU/s, of the speed of the encoder.
  double velocity() const noexcept { return valid_ ? velocity_ : 0.0; }
  /// r2522, LU/s, as r2521.
  double velocity_of(std::size_t index) const noexcept;
  /// LU, at the last zero mark or probe that was asked for.
  double measured() const noexcept { return own().measured().exact(); }
  /// r2523[0], LU: the same in whole LU.
  std::int64_t measured_shown() const noexcept { return own().measured().whole; }
  /// r2523, LU, as r2521.
  double measured_of(std::size_t index) const noexcept;
  /// r2524, LU in a revolution of the motor.
  double units_per_revolution() const noexcept;
  /// r2667, LU.
  double backlash_compensation() const noexcept { return static_cast<double>(backlash_.compensation()); }
  /// LU that the last slice took off the position, whole modulo ranges.
  std::int64_t wrapped() const noexcept { return wrapped_; }

  /// r2526.0
  bool position_valid() const noexcept { return valid_ && !overflows(); }
  /// r2526.1
  bool referencing_active() const noexcept { return own().capture().awaits(); }
  /// r2526.2
  bool measured_valid() const noexcept { return own().capture().has_captured(); }
  /// r2526.9: an absolute encoder is adjusted.
  bool adjusted() const noexcept;
  /// The bits of r2526 that are those of the position, and r2527 to r2529 of encoder 1 to 3.
  std::uint16_t status() const noexcept;
  std::uint16_t encoder_status(std::size_t encoder) const noexcept;
  /// In this slice the reference was lost.
  bool reference_lost() const noexcept { return reference_lost_; }

  bool overflows() const noexcept;                                                   ///< F07493, value 1
  bool has_no_encoder() const noexcept { return no_encoder_; }                       ///< A07454
  bool encoder_faulty() const noexcept { return !no_encoder_ && fault_; }            ///< F07453
  bool interrupted() const noexcept { return own().capture().is_interrupted(); }     ///< A07495
  bool is_held() const noexcept { return own().is_held(); }                          ///< A07497
  bool probe_impossible() const noexcept { return own().capture().refusal() != 0; }  ///< A07498
  double probe_refusal() const noexcept { return own().capture().refusal(); }        ///< its value
  bool adjustment_refused() const noexcept { return adjustment_refused_; }           ///< F07443
  double largest_coordinate() const noexcept;                                        ///< its value (LU)
  bool adjustment_unsaved() const noexcept { return unsaved_; }                      ///< A07441
  bool multiturn_mismatch() const noexcept { return multiturn_mismatch_; }           ///< F07442

  // The same of encoder 1.
  bool encoder_1_overflows() const noexcept;                                                         ///< A07593
  bool encoder_1_missing() const noexcept { return encoder_.type == motor::EncoderType::None; }      ///< A07587
  bool encoder_1_faulty() const noexcept { return !encoder_1_missing() && fault_; }                  ///< A07581
  bool encoder_1_interrupted() const noexcept { return encoder_1().capture().is_interrupted(); }     ///< A07596
  bool encoder_1_held() const noexcept { return encoder_1().is_held(); }                             ///< A07584
  bool encoder_1_probe_impossible() const noexcept { return encoder_1().capture().refusal() != 0; }  ///< A07577
  double encoder_1_probe_refusal() const noexcept { return encoder_1().capture().refusal(); }        ///< its value

  Settings settings{};
  Inputs inputs{};

 private:
  static constexpr std::size_t kOwn = 0;      ///< of the position control, among the values
  static constexpr std::size_t kEncoder = 1;  ///< of encoder 1, among the values

  /// What scale and place of zero follow from.
  struct Mechanics {
    LengthMechanics lengths{};
    std::int32_t encoder = 0;
    double units_per_10_mm = 0.0;

    friend bool operator==(const Mechanics&, const Mechanics&) = default;
  };

  Mechanics mechanics() const noexcept;
  static CaptureRequest released(const CaptureRequest& wired, const Slice& slice) noexcept;
  CaptureTerminals terminals() const noexcept;
  PositionChannel& own() noexcept { return channels_.front(); }
  const PositionChannel& own() const noexcept { return channels_.front(); }
  PositionChannel& encoder_1() noexcept { return channels_.back(); }
  const PositionChannel& encoder_1() const noexcept { return channels_.back(); }
  ChannelInputs inputs_of(std::size_t index) const noexcept;
  bool is_absolute() const noexcept { return encoder_.type == motor::EncoderType::Absolute; }
  std::int64_t adjustment_offset() const noexcept;
  std::int64_t without_channel() const noexcept;
  std::int64_t whole() const noexcept { return without_channel() + own().added(); }
  std::int64_t encoder_1_whole() const noexcept { return sensed_.whole + encoder_1().added(); }
  bool encoder_1_valid() const noexcept;
  void follow_mechanics() noexcept;
  void watch_encoder(const Slice& slice) noexcept;
  void follow_backlash(bool active) noexcept;
  void count(std::int64_t counts) noexcept;
  void follow_adjustment(double coordinate) noexcept;
  bool adjust(std::int64_t coordinate) noexcept;
  void follow_modulo(const Slice& slice) noexcept;
  void take_measured(Length from, const Backlash& play) noexcept;
  void ask(const Slice& slice) noexcept;
  double noted_position() const noexcept;
  void fold_absolute() noexcept;
  Length measured_length(std::int64_t counts) const noexcept { return scale_.length(base_ + counts); }

  motor::EncoderData encoder_;
  std::int64_t per_revolution_;  // increments
  std::int64_t start_;           // increments past the zero of the disc where counting began
  std::int64_t base_ = 0;        // increments that power-on adds to the counts
  std::int64_t counts_ = 0;      // at the end of the slice that has passed
  std::optional<Mechanics> known_{};
  LengthScale scale_{};
  Length sensed_{};  // of the encoder alone
  Backlash backlash_{};
  CaptureRequest wired_{};                     // as the inputs asked at the end of the slice that has passed
  std::array<PositionChannel, 2> channels_{};  // of index 0 and of encoder 1
  double velocity_ = 0.0;                      // of the encoder
  std::int64_t modulo_range_ = 0;
  std::int64_t matched_range_ = 0;  // that multiturn_mismatch_ was found with
  std::int64_t wrapped_ = 0;
  double noted_speed_ = 0.0;  // rad/s
  bool runs_ = false;
  bool valid_ = false;
  bool no_encoder_ = false;
  bool fault_ = false;  // of the encoder
  bool reference_lost_ = false;
  bool invalidated_ = false;
  bool adjustment_refused_ = false;
  bool unsaved_ = false;
  bool multiturn_mismatch_ = false;
};

}  // namespace drive
