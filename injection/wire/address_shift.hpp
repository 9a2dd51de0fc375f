#pragma once

#include <cstdint>
#include <optional>

#include "libcanopen/base/frame.hpp"

namespace injection {

/// A unit that uses the identifiers of another node: how its frames look on the bus, and those of the bus to it.
/// What does not belong to the pre-defined connection set of either passes as it is.
class AddressShift {
 public:
  /// The node @p own is @p other on the bus.
  AddressShift(std::uint8_t own, std::uint8_t other) noexcept : own_{own}, other_{other} {}

  /// A frame that the unit sends, as it is on the bus.
  canopen::Frame outward(canopen::Frame frame) const noexcept {
    if (belongs_to(frame, own_)) set_node(frame, other_);
    return frame;
  }
  /// A frame of the bus, as the unit hears it; nothing: it does not.
  std::optional<canopen::Frame> inward(canopen::Frame frame) const noexcept {
    if (is_command(frame)) return command_inward(frame);
    if (belongs_to(frame, own_) && own_ != other_) return std::nullopt;
    if (belongs_to(frame, other_)) set_node(frame, own_);
    return frame;
  }
  /// The identifier under which the bus has @p identifier of the unit.
  std::uint32_t outward(std::uint32_t identifier) const noexcept {
    return outward(canopen::Frame{.id = identifier}).id;
  }

 private:
  static constexpr std::uint32_t kNode = 0x7F;
  static constexpr std::uint32_t kFirst = 0x081;  ///< EMCY of node 1
  static constexpr std::uint32_t kLast = 0x77F;   ///< error control of node 127
  static constexpr std::uint32_t kTime = 0x100;

  static bool is_command(const canopen::Frame& frame) noexcept {
    return frame.id == 0 && !frame.extended && !frame.remote && frame.length == 2;
  }
  static bool belongs_to(const canopen::Frame& frame, std::uint8_t node) noexcept {
    const bool is_of_nodes = frame.id >= kFirst && frame.id <= kLast && frame.id != kTime;
    return !frame.extended && is_of_nodes && (frame.id & kNode) == node;
  }
  static void set_node(canopen::Frame& frame, std::uint8_t node) noexcept {
    frame.id = (frame.id & ~kNode) | node;
  }
  std::optional<canopen::Frame> command_inward(canopen::Frame frame) const noexcept {
    if (frame.data[1] == own_ && own_ != other_) return std::nullopt;
    if (frame.data[1] == other_) frame.data[1] = own_;
    return frame;
  }

  std::uint8_t own_;
  std::uint8_t other_;
};

}  // namespace injection
