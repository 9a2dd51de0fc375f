#pragma once

#include <cstdint>

#include "libcanopen/base/time.hpp"

namespace hub {

class Participant;
struct Identity;
struct Passage;

/// Who hears a frame.
class Audience {
 public:
  Audience() = default;
  Audience(const Audience&) = delete;
  Audience& operator=(const Audience&) = delete;
  virtual ~Audience() = default;

  [[nodiscard]] virtual bool hears(const Participant& participant) const noexcept = 0;
};

/// What stands between the wire and those who hear it: the faults of the bus, while there are any.
class Interference {
 public:
  Interference() = default;
  Interference(const Interference&) = delete;
  Interference& operator=(const Interference&) = delete;
  virtual ~Interference() = default;

  /// @p passage has come to its end on the wire at @p end, and nobody has heard it yet: what becomes of it is done
  /// by Medium::hand_out() and Medium::repeat(). @p sender says who has sent it, also if that has left.
  virtual void on_end(const Passage& passage, const Identity& sender, canopen::TimePoint end) noexcept = 0;
  /// @p participant leaves: it is named as a sender no more.
  virtual void on_detach(const Participant& participant) noexcept = 0;
  /// When on_time() is wanted.
  [[nodiscard]] virtual canopen::TimePoint next_deadline() const noexcept = 0;
  /// Everything that had its end until @p now has been told. Medium::set_bit_rate() is allowed here.
  virtual void on_time(canopen::TimePoint now) noexcept = 0;
};

}  // namespace hub
