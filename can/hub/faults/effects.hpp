#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include <linux/can.h>

#include "can/hub/faults/talker.hpp"
#include "can/hub/medium/medium.hpp"
#include "injection/language/fault.hpp"
#include "injection/language/trigger.hpp"

namespace hub::faults {

/// What becomes of a frame on its way from the wire to those who hear it, its sender not included.
struct Fate {
  can_frame heard{};
  bool lost = false;
  bool twice = false;
  canopen::Duration delay{};
};

/// What the faults of one kind do. Of the functions those that a kind has no use for are nullptr.
struct Effect {
  std::string_view kind;
  /// Hits a frame.
  void (*change)(const injection::Fault& fault, Fate& fate) noexcept;
  /// Whether there is something at @p frame that can be hit.
  bool (*can_change)(const injection::Fault& fault, const can_frame& frame) noexcept;
  /// Makes the one who sends frames.
  std::unique_ptr<Talker> (*make_talker)(const injection::Fault& fault, Medium& medium,
                                         injection::Trigger& trigger);
  /// Whether it makes sense only where frames take time.
  bool (*needs_bit_rate)(const injection::Fault& fault) noexcept;
};

/// That of the kind of @p fault, which is one of injection::bus_kinds().
const Effect& effect_of(const injection::Fault& fault) noexcept;

}  // namespace hub::faults
