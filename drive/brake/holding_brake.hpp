#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace drive {
namespace explanation {
struct Reason;
}

/// The motor holding brake as the sequence control leads it: open with the pulses, closed at the end of a braking
/// while the motor still holds.
class HoldingBrake {
 public:
  struct Settings {
    using Block = HoldingBrake;

    std::int32_t configuration = 0;  ///< p1215: 0 none, 1 and 3 by the sequence control, 2 always open
    double opening_time = 0.0;       ///< p1216 (s), for which the setpoint waits
    double closing_time = 0.0;       ///< p1217 (s), for which the motor still holds
  };

  /// Whether there is one that the sequence control leads; an axis has one if it is @p mounted.
  bool is_led(bool mounted) const noexcept {
    constexpr std::int32_t kBySequenceControl = 1, kWithOwnFeedback = 3;
    return mounted && (settings.configuration == kBySequenceControl || settings.configuration == kWithOwnFeedback);
  }
  /// A cycle of @p duration (s) in which it is to be @p open.
  void lead(bool open, double duration) noexcept {
    opening_ = open ? std::max(0.0, opening_ - duration) : settings.opening_time;
  }
  /// Somebody beside the sequence control holds it @p closed; without that the sequence control leads it.
  void hold(bool closed) noexcept { held_closed_ = closed; }
  bool is_held_closed() const noexcept { return held_closed_; }
  /// Time until it is open (s).
  double opening() const noexcept { return opening_; }
  bool is_opening() const noexcept { return opening_ > 0.0; }

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};

 private:
  double opening_ = 0.0;  // s
  bool held_closed_ = false;
};

}  // namespace drive
