#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/messages/fault_table.hpp"

namespace drive {

/// What a drive object makes of messages other than the table says: p2100 and p2101, p2118 and p2119.
struct MessageSettings {
  static constexpr std::size_t kCount = 20;

  std::array<std::uint16_t, kCount> reaction_numbers{};   ///< p2100, 0 = unused
  std::array<std::uint8_t, kCount> reactions{};           ///< p2101: 0 NONE, 1..3 OFF1..3, 5 STOP2, 6 IASC/DCBRK
  std::array<std::uint16_t, kCount> type_numbers{};       ///< p2118, 0 = unused
  std::array<std::uint8_t, kCount> types = all_faults();  ///< p2119: 1 fault, 2 alarm, 3 no message

  /// The reaction that p2101 gives to @p row, if the row offers it.
  std::optional<Reaction> reaction_to(const FaultRow& row) const noexcept;
  /// What @p row is as p2119 says, otherwise as the table says; nothing = no message.
  std::optional<Kind> kind_of(const FaultRow& row) const noexcept;

  friend bool operator==(const MessageSettings&, const MessageSettings&) = default;

 private:
  static constexpr std::array<std::uint8_t, kCount> all_faults() noexcept {
    std::array<std::uint8_t, kCount> types{};
    types.fill(1);
    return types;
  }
};

}  // namespace drive
