#pragma once

#include <cstdint>

#include "drive/axis.hpp"
#include "libcanopen/node/node.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Drive object number of the first axis; 1 is the control unit.
inline constexpr std::uint8_t kFirstAxisObject = 2;

/// Shows the faults and alarms of the axis on the bus: error register 1001h, active messages 1003h (not a history)
/// and emergency messages.
class ErrorObjects final : public canopen::EntryOwner {
 public:
  /// Owns the reading of 1003h:00 in @p dictionary; the arguments must outlive this.
  ErrorObjects(canopen::Dictionary& dictionary, drive::Axis& axis);

  /// Brings the objects up to date and sends an emergency message for every message that entered since the last
  /// call, and one with code 0000h when the last one has left.
  void update(canopen::Node& node) noexcept;

  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;

 private:
  void fill(const drive::FaultMemory& messages) noexcept;
  void set(std::uint8_t sub_index, std::uint32_t value) noexcept;
  void report(const drive::FaultMemory& messages, canopen::Node& node) noexcept;
  static bool is_reported(const drive::FaultEntry& entry) noexcept { return entry.emcy_code() != 0; }

  canopen::Dictionary& dictionary_;
  drive::Axis& axis_;
  canopen::Cell<std::uint8_t> error_register_;
  std::uint32_t seen_change_ = 0;
  std::uint32_t seen_sequence_ = 0;
  std::uint32_t entries_ = 0;  ///< messages that 1003h shows now
};

}  // namespace device
