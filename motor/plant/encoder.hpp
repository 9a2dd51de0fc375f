#pragma once

#include <cmath>
#include <cstdint>

#include "motor/data/machine_data.hpp"
#include "motor/plant/encoder_track.hpp"

namespace motor {

/// What can be wrong with an encoder.
enum class EncoderDefect : std::uint8_t {
  None,
  Loss,        ///< no signals: the counts stay, the encoder says so
  LostPulses,  ///< a part of the disc gives no pulses; only the next zero marks show it
  Reversed,    ///< tracks exchanged: it counts the wrong way and notices nothing
};

/// What an encoder knows to be wrong.
struct EncoderStatus {
  bool signal_lost = false;              ///< no amplitude on the tracks, F31116
  std::int32_t zero_mark_deviation = 0;  ///< of the last distance of two zero marks (4 a pulse), F31100 if not 0

  friend bool operator==(const EncoderStatus&, const EncoderStatus&) = default;
};

/// Motor encoder: whole increments of the true angle, never a sum of rounded ones, and the speed as the difference
/// quotient of the increments. Revolutions are whole numbers, so no position is lost however long the shaft turns.
class Encoder {
 public:
  explicit Encoder(const MachineData& machine) noexcept;

  /// Fixes the sampling period (s) and with it the smoothing of the measured speed.
  void configure(double period) noexcept;
  /// The shaft is at @p revolutions + @p angle (rad, 0..2π) from its place at power-on, one period after the last
  /// call.
  void move_to(double revolutions, double angle) noexcept {
    const auto moved = static_cast<std::int64_t>(track_.turn_to(revolutions, angle));
    position_ += moved;
    const std::int64_t counted = sound_ ? moved : counts_at(position_) - counts_;
    counts_ += counted;
    track_.follow(static_cast<double>(counted));
    if (track_.is_past_mark()) look_for_zero_mark();
  }
  /// The track has come past @p moved increments since this was last called, by itself.
  void count(double moved) noexcept;
  /// Turns the shaft by @p angle (rad) within one period.
  void turn(double angle) noexcept;
  /// From now on the encoder has @p defect instead of the one before; what it has counted stays.
  void inject(EncoderDefect defect) noexcept;
  /// Forgets what was wrong; what still is comes back.
  void acknowledge() noexcept { status_ = {.signal_lost = defect_ == EncoderDefect::Loss}; }

  /// Increments since power-on (Gn_XIST1 without its wrap); negative after turning backwards.
  std::int64_t counts() const noexcept { return counts_; }
  /// Absolute position in increments of the finer resolution p0419, over p0421 revolutions (Gn_XIST2); 0 without
  /// an absolute encoder.
  std::uint32_t absolute_position() const noexcept;
  /// Measured speed (rad/s), smoothed with filter_time().
  double speed() const noexcept { return track_.speed; }
  /// Time constant of the smoothing (s): just enough for the encoder's resolution, 0 for a very fine one.
  double filter_time() const noexcept { return filter_time_; }
  /// Whether it counts what its track comes past; without an encoder nothing does.
  bool counts_all() const noexcept { return sound_; }
  /// Whether what it counts is neither all nor nothing.
  bool has_defect() const noexcept { return defect_ != EncoderDefect::None; }
  const EncoderStatus& status() const noexcept { return status_; }
  EncoderDefect defect() const noexcept { return defect_; }

 private:
  template <class Number>
  friend class LaneTrain;

  std::int64_t seen(std::int64_t position) const noexcept;
  std::int64_t counts_at(std::int64_t position) const noexcept;
  void look_for_zero_mark() noexcept;

  EncoderData data_;
  std::int64_t per_revolution_;  // increments
  double tolerated_ripple_;      // rad/s
  double filter_time_ = 0.0;     // s
  EncoderTrack<double> track_;

  std::int64_t start_;     // increments past the zero of the disc at power-on
  std::int64_t position_;  // true increments past that zero
  double angle_ = 0.0;     // rad, for turn()
  double revolutions_ = 0.0;

  EncoderDefect defect_ = EncoderDefect::None;
  std::int64_t blind_ = 0;        // increments after each zero mark that give no pulses
  std::int64_t base_counts_ = 0;  // where the defect began
  std::int64_t base_position_;
  std::int64_t mark_;             // revolution that the shaft is in, counted by its zero marks
  std::int64_t mark_counts_ = 0;  // counts at the last mark
  bool mark_seen_ = false;
  std::int64_t counts_ = 0;
  EncoderStatus status_;
  bool sound_;  // there is an encoder, and it has no defect
};

}  // namespace motor
