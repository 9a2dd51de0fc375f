#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/messages/time_stamp.hpp"

namespace drive {

/// A fault or alarm as the buffers show it.
struct BufferEntry {
  std::uint16_t number = 0;  ///< 0 = empty
  std::uint32_t value = 0;   ///< r0949, r2124
  TimeStamp received{};      ///< r0948, r2123
  TimeStamp removed{};       ///< r2109, r2125; 0 while it is active
};

/// The past seven fault cases of eight faults; the current case is what is active now.
class FaultHistory {
 public:
  static constexpr std::size_t kFaults = 8;
  static constexpr std::size_t kCases = 7;

  /// Takes up the faults that left together as the latest case, in the order of their appearance; the oldest case
  /// is lost.
  void push(std::span<const BufferEntry> faults) noexcept {
    std::move_backward(entries_.begin(), entries_.end() - kFaults, entries_.end());
    std::fill_n(entries_.begin(), kFaults, BufferEntry{});
    std::copy_n(faults.begin(), std::min(faults.size(), kFaults), entries_.begin());
  }
  /// Forgets every case.
  void clear() noexcept { entries_.fill(BufferEntry{}); }
  /// Takes the first 56 of @p entries as the cases of a former life.
  void assign(std::span<const BufferEntry> entries) noexcept {
    std::copy_n(entries.begin(), std::min(entries.size(), entries_.size()), entries_.begin());
  }
  /// Entry 0..55, the latest case first.
  const BufferEntry& at(std::size_t index) const noexcept { return entries_[index]; }

 private:
  std::array<BufferEntry, kFaults * kCases> entries_{};
};

/// The alarm buffer r2122: eight current alarms in the order of their appearance, then 56 that are gone, the
/// latest first. A current one that is gone stays in its place until the place is needed.
class AlarmBuffer {
 public:
  static constexpr std::size_t kCurrent = 8;
  static constexpr std::size_t kEntries = 64;

  /// An alarm appears at @p now; the buffer holds fewer than eight active ones.
  void enter(std::uint16_t number, std::uint32_t value, const TimeStamp& now) noexcept;
  /// The active alarm @p number takes another value.
  void change(std::uint16_t number, std::uint32_t value) noexcept;
  /// The active alarm @p number disappears at @p now.
  void leave(std::uint16_t number, const TimeStamp& now) noexcept;
  /// Forgets all that are gone (p2111 = 0).
  void clear() noexcept;
  /// Entry 0..63.
  const BufferEntry& at(std::size_t index) const noexcept { return entries_[index].shown; }

 private:
  struct Entry {
    BufferEntry shown;
    bool active = false;
  };

  Entry* find_active(std::uint16_t number) noexcept;
  void archive() noexcept;

  std::array<Entry, kEntries> entries_{};
  std::size_t current_ = 0;  // used entries below kCurrent
};

}  // namespace drive
