#pragma once

#include <cstdint>
#include <deque>
#include <iosfwd>
#include <string>

#include "can/hub/medium/medium.hpp"
#include "sim/base/told_time.hpp"

namespace sim {

/// A frame as candump -L prints it, at @p seconds since the beginning of its world.
std::string log_line(double seconds, const can_frame& frame);

/// Hears all frames of a world: what tells two runs apart, and the last of them.
class WireRecorder final : private hub::Participant {
 public:
  /// Frames that are kept.
  static constexpr std::size_t kKept = 40;
  struct Heard {
    canopen::TimePoint time;
    can_frame frame;
  };

  /// Of @p medium, which outlives this.
  WireRecorder(hub::Medium& medium, const ToldTime& time) : medium_{medium}, time_{time} { medium_.attach(*this); }
  ~WireRecorder() override { medium_.detach(*this); }

  /// From now on all frames go to @p log too, which outlives this, as candump -L prints them.
  void write_to(std::ostream& log) noexcept { log_ = &log; }

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  /// The bits of all of them on the wire.
  [[nodiscard]] std::uint64_t bits() const noexcept { return bits_; }
  /// A number that the same frames at the same times give, and no others.
  [[nodiscard]] std::uint64_t digest() const noexcept { return digest_; }
  [[nodiscard]] const std::deque<Heard>& last() const noexcept { return last_; }

 private:
  void receive(const hub::Passage& passage) noexcept override;
  void take(std::uint64_t word) noexcept;

  hub::Medium& medium_;
  const ToldTime& time_;
  std::uint64_t frames_ = 0;
  std::uint64_t bits_ = 0;
  std::uint64_t digest_ = 0xCBF2'9CE4'8422'2325;
  std::deque<Heard> last_;
  std::ostream* log_ = nullptr;
};

}  // namespace sim
