#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/positioning/modes/positioner_settings.hpp"

namespace drive {

/// p2621.
enum class BlockTask : std::uint8_t {
  Positioning = 1,
  FixedStop,
  EndlessPositive,
  EndlessNegative,
  Wait,
  Goto,
  SetOutput,
  ResetOutput,
  Jerk,
};
/// Bits 4 to 7 of p2623.
enum class Continuation : std::uint8_t { End, WithStop, Flying, External, ExternalWait, ExternalAlarm };
/// Bits 8 to 11 of p2623.
enum class TargetKind : std::uint8_t { Absolute, Relative, AbsolutePositive, AbsoluteNegative };

/// An entry of the table of traversing blocks (p2616 to p2623).
struct TraversingBlock {
  int number = -1;
  BlockTask task = BlockTask::Positioning;
  std::int32_t parameter = 0;
  std::uint16_t mode = 0;  ///< p2623
  double position = 0.0;   ///< LU
  double velocity = 0.0;   ///< LU/s
  double acceleration = 1.0;
  double deceleration = 1.0;

  bool is_hidden() const noexcept { return (mode & 1U) != 0; }
  unsigned continuation_code() const noexcept { return mode >> 4U & 0xFU; }
  unsigned target_code() const noexcept { return mode >> 8U & 0xFU; }
  Continuation continuation() const noexcept { return static_cast<Continuation>(continuation_code()); }
  TargetKind target_kind() const noexcept { return static_cast<TargetKind>(target_code()); }
  /// Whether a signal changes to the next block.
  bool awaits_signal() const noexcept { return continuation() >= Continuation::External; }
  /// Whether it moves the axis.
  bool moves() const noexcept { return task <= BlockTask::EndlessNegative; }
};

/// The entries in the order of their numbers.
class BlockTable {
 public:
  explicit BlockTable(const PositionerSettings& settings) noexcept : settings_{settings} {}

  /// Entries that count (p2615).
  std::size_t size() const noexcept;
  TraversingBlock at(std::size_t entry) const noexcept;
  /// The first entry of block @p number, if there is one that is not hidden.
  std::optional<TraversingBlock> find(int number) const noexcept;
  /// The block that follows @p number: the lowest higher one that is not hidden.
  std::optional<TraversingBlock> after(int number) const noexcept;
  /// Whether @p number is given to more than one entry.
  bool is_twice(int number) const noexcept;

 private:
  const PositionerSettings& settings_;
};

/// p2624 = 1: sorts the entries by their numbers, unused ones last.
void sort_blocks(PositionerSettings& settings) noexcept;

}  // namespace drive
