#pragma once

#include <cstdint>
#include <optional>

#include "drive/positioning/actual_position/length_scale.hpp"
#include "drive/positioning/actual_position/position_capture.hpp"

namespace drive {

/// What is wired to one index of p2508 to p2516 and p2730.
struct ChannelInputs {
  CaptureRequest request{};
  bool correct = false;             ///< p2512
  bool correct_negatively = false;  ///< p2730
  bool set_position = false;        ///< p2514
  double correction = 0.0;          ///< p2513 (LU)
  double setting_value = 0.0;       ///< p2515 (LU)
  double offset = 0.0;              ///< p2516 (LU)
};

/// One of the positions that are made of what an encoder senses, by what is added to it in whole length units
/// (LU), and its value at a zero mark or probe. Index 0 is that of the position control, 1 to 3 are those of the
/// encoders.
class PositionChannel {
 public:
  /// Power-on: nothing has been added yet.
  void power_on() noexcept { *this = {}; }
  /// A process-data cycle begins.
  void begin_cycle() noexcept { capture_.begin_cycle(); }
  /// Looks for the event that is waited for in a slice that has passed.
  void look(const DiscMotion& motion, const InputEdges& edges) noexcept {
    captured_ = capture_.look(motion, edges);
  }
  /// Takes offset, edges of corrections and setting value, where @p sensed (LU) is the position without them.
  void follow(const ChannelInputs& inputs, std::int64_t sensed) noexcept;
  /// What is asked for from now on, possible or not.
  void ask(const CaptureRequest& request, const CaptureTerminals& terminals, bool possible) noexcept {
    capture_.follow(request, terminals, possible && !held_);
  }

  /// The position becomes greater by @p by (LU).
  void shift(std::int64_t by) noexcept { offset_ += by; }
  /// Forgets what was set and corrected.
  void clear() noexcept { offset_ = 0; }
  /// LU beside what the encoder senses.
  std::int64_t added() const noexcept { return offset_ + wired_; }

  /// The event in the slice that has passed, if it came.
  const std::optional<Captured>& captured() const noexcept { return captured_; }
  /// It came at @p position.
  void set_measured(Length position) noexcept { measured_ = position; }
  /// r2523, of the last event.
  const Length& measured() const noexcept { return measured_; }

  const PositionCapture& capture() const noexcept { return capture_; }
  /// p2514 keeps it where it is.
  bool is_held() const noexcept { return held_; }

 private:
  PositionCapture capture_{};
  std::optional<Captured> captured_{};
  Length measured_{};
  std::int64_t offset_ = 0;  // LU, all that was set and corrected since power-on
  std::int64_t wired_ = 0;   // LU, p2516
  bool corrects_ = false;    // p2512 and p2730 in the last slice
  bool corrects_negatively_ = false;
  bool held_ = false;
};

/// Whole length units of an input.
std::int64_t whole_units(double value) noexcept;

}  // namespace drive
