#pragma once

#include <cstdint>

#include <linux/can.h>

#include "injection/language/event.hpp"
#include "injection/language/fault.hpp"

namespace hub::faults {

/// Which frames a fault is about: `id` and `mask`. Identifiers up to 7FFh mean standard frames, above extended
/// ones.
class FrameRange {
 public:
  explicit FrameRange(const injection::Fault& fault) noexcept {
    using injection::Argument;
    const auto id = fault.value(Argument::Id);
    if (!id) return;
    const bool is_extended = *id > CAN_SFF_MASK || fault.value_or(Argument::Mask, 0) > CAN_SFF_MASK;
    mask_ = fault.value_or(Argument::Mask, CAN_EFF_MASK) | CAN_EFF_FLAG;
    id_ = (*id | (is_extended ? CAN_EFF_FLAG : 0)) & mask_;
  }

  [[nodiscard]] bool has(const can_frame& frame) const noexcept { return (frame.can_id & mask_) == id_; }

 private:
  canid_t id_ = 0;
  canid_t mask_ = 0;
};

/// @p frame as the language counts it. An extended frame with an identifier that a standard one can have has none
/// there.
constexpr injection::Occurrence occurrence_of(const can_frame& frame) noexcept {
  const bool is_extended = (frame.can_id & CAN_EFF_FLAG) != 0;
  const std::uint32_t identifier = frame.can_id & (is_extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  const bool is_ambiguous = is_extended && identifier <= CAN_SFF_MASK;
  return {.kind = injection::EventKind::Frame,
          .identifier = is_ambiguous ? identifier | CAN_EFF_FLAG : identifier};
}

}  // namespace hub::faults
