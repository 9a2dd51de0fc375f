#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/fault_table.hpp"

namespace drive {

/// Whether the cause of a message is still there after it was raised.
enum class Cause : std::uint8_t { Gone, Present };

/// An active fault or alarm.
struct FaultEntry {
  const FaultRow* row = nullptr;
  std::uint32_t value = 0;     ///< fault value (r0949) or alarm value (r2124)
  std::uint32_t sequence = 0;  ///< ascending over all messages of the memory, from 1
  Cause cause = Cause::Gone;

  /// CANopen error code; F08700 has its own one only for life guarding (value 2).
  std::uint16_t emcy_code() const noexcept;
};

/// The active faults and alarms of one drive object, oldest first: room for eight of each, what comes after that
/// is not entered. A layer above notices news by change_count() and new entries by their sequence number.
class FaultMemory {
 public:
  static constexpr std::size_t kCapacity = 8;

  /// Enters a message. One that is active already only takes over @p value and @p cause.
  void enter(const FaultRow& row, std::uint32_t value, Cause cause) noexcept;
  /// The cause of @p row is gone: an alarm leaves, a fault can be acknowledged from now on.
  void withdraw(const FaultRow& row) noexcept;
  /// Removes every fault that may be acknowledged now; true if no fault is left.
  bool acknowledge(bool pulses_enabled) noexcept;
  /// Removes everything, as power-off does.
  void clear() noexcept;

  /// Active faults, oldest first.
  std::span<const FaultEntry> faults() const noexcept { return faults_.entries(); }
  /// Active alarms, oldest first.
  std::span<const FaultEntry> alarms() const noexcept { return alarms_.entries(); }
  /// Changes with every message that enters, leaves or takes another value.
  std::uint32_t change_count() const noexcept { return change_count_; }
  /// The message that entered last among the active ones, or nullptr.
  const FaultEntry* most_recent() const noexcept;
  /// Bits of the error register 1001h.
  std::uint8_t error_register() const noexcept;

 private:
  struct List {
    std::array<FaultEntry, kCapacity> items{};
    std::size_t count = 0;

    std::span<const FaultEntry> entries() const noexcept { return {items.data(), count}; }
    FaultEntry* find(const FaultRow& row) noexcept;
    /// Removes what @p leaves accepts and keeps the order; returns how many went.
    template <class Predicate>
    std::size_t remove_if(Predicate leaves) noexcept;
  };

  List& list_of(const FaultRow& row) noexcept { return row.kind == Kind::Fault ? faults_ : alarms_; }

  List faults_;
  List alarms_;
  std::uint32_t sequence_ = 0;
  std::uint32_t change_count_ = 0;
};

}  // namespace drive
