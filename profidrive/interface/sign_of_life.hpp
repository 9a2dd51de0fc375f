#pragma once

#include <cstdint>

namespace profidrive {

/// The sign of life of a controller and that of the drive object: counters from 1 to 15, 0 being none
/// (PROFIdrive).
class SignOfLife {
 public:
  static constexpr unsigned kLast = 15;
  /// p0925: any number of wrong values is allowed.
  static constexpr std::uint16_t kNotMonitored = 65535;

  /// The controller has sent @p value (0..15); @p tolerance (p0925): wrong values in a row that are allowed. True
  /// if it has failed with that: F01912.
  bool receive(unsigned value, std::uint16_t tolerance) noexcept {
    if (!runs_ && value == 0) return false;
    const bool is_good = !runs_ || value == next(received_);
    runs_ = true;
    received_ = value;
    if (is_good) return on_good();
    good_in_a_row_ = 0;
    if (total_wrong_ < UINT16_MAX) ++total_wrong_;
    if (wrong_in_a_row_ < UINT16_MAX) ++wrong_in_a_row_;
    if (has_failed_ || tolerance == kNotMonitored || wrong_in_a_row_ <= tolerance) return false;
    return has_failed_ = true;
  }
  /// A cycle of the interface is over: the own counter goes on once that of the controller runs.
  void advance() noexcept {
    if (runs_) sent_ = next(sent_);
  }
  /// What is sent (0..15).
  unsigned sent() const noexcept { return sent_; }
  bool runs() const noexcept { return runs_; }
  /// Wrong values since the start (r2065).
  std::uint16_t total_wrong() const noexcept { return total_wrong_; }
  /// The controller has gone; the next value is the first one.
  void stop() noexcept {
    const std::uint16_t total = total_wrong_;
    *this = {};
    total_wrong_ = total;
  }

 private:
  /// So many good values in a row make it synchronous again.
  static constexpr unsigned kSynchronous = 15;

  static constexpr unsigned next(unsigned value) noexcept { return value % kLast + 1; }
  bool on_good() noexcept {
    wrong_in_a_row_ = 0;
    if (has_failed_ && ++good_in_a_row_ >= kSynchronous) has_failed_ = false;
    return false;
  }

  unsigned received_ = 0;
  unsigned sent_ = 0;
  unsigned good_in_a_row_ = 0;
  std::uint16_t wrong_in_a_row_ = 0;
  std::uint16_t total_wrong_ = 0;
  bool runs_ = false;
  bool has_failed_ = false;
};

}  // namespace profidrive
