#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "drive/messages/fault_table.hpp"
#include "drive/messages/message_buffers.hpp"
#include "drive/messages/message_settings.hpp"

namespace drive {

/// Whether the cause of a message is still there after it was raised.
enum class Cause : std::uint8_t {
  Gone,
  Present,
  Ending,   ///< present, but an acknowledgement meanwhile counts as soon as it is gone
  Latched,  ///< gone, but an alarm stays until it is withdrawn or p2111 = 0
};

/// An active fault or alarm.
struct FaultEntry {
  const FaultRow* row = nullptr;
  std::uint32_t value = 0;     ///< fault value (r0949) or alarm value (r2124)
  std::uint32_t sequence = 0;  ///< ascending over all messages of the memory (see number_by()), from 1
  Cause cause = Cause::Gone;
  Kind kind = Kind::Fault;  ///< what the row or p2119 makes of it
  TimeStamp received{};
  bool acknowledged = false;  ///< a fault whose cause is Ending

  /// CANopen error code, 0 = no EMCY; F08700 has its own one only for life guarding (value 2).
  std::uint16_t emcy_code() const noexcept;
  /// Bits it sets in 1001h: a message of the communication as fault and as alarm, another one as a fault only.
  std::uint8_t error_register() const noexcept;
  /// When an acknowledgement removes it; an alarm that p2119 makes a fault leaves at once.
  Acknowledge acknowledge() const noexcept;
};

/// The faults and alarms of one drive object, active ones oldest first: room for eight of each, what comes after
/// that is not entered. A layer above notices news by change_count() and new entries by their sequence number.
/// What has left is kept in the buffers.
class FaultMemory {
 public:
  static constexpr std::size_t kCapacity = 8;

  /// Tells the time (ms) that holds for what follows, unless there is a common one.
  void set_time(Uptime now) noexcept { own_time_.now = now; }
  /// Enters a message as what the settings make of it, if anything. One that is active already only takes over
  /// @p value and @p cause.
  void enter(const FaultRow& row, std::uint32_t value, Cause cause) noexcept;
  /// The cause of @p row is gone: an alarm leaves, a fault can be acknowledged from now on. One that was
  /// acknowledged while its cause was Ending leaves, too; true if one did.
  bool withdraw(const FaultRow& row) noexcept;
  /// Removes every fault that may be acknowledged now; true if no fault is left.
  bool acknowledge(bool pulses_enabled) noexcept;
  /// Removes everything that is active, as power-off does; the buffers remain.
  void clear() noexcept;

  /// From now on @p counter, which outlives this, numbers the messages: common to memories whose order matters.
  void number_by(std::uint32_t& counter) noexcept { common_sequence_ = &counter; }
  /// From now on @p time, which outlives this, stamps the messages: that of the unit.
  void stamp_by(const TimeLine& time) noexcept { common_time_ = &time; }

  /// Active faults, oldest first.
  std::span<const FaultEntry> faults() const noexcept { return faults_.entries(); }
  /// Active alarms, oldest first.
  std::span<const FaultEntry> alarms() const noexcept { return alarms_.entries(); }
  /// Changes with every message that enters, leaves or takes another value, and when a buffer is cleared.
  std::uint32_t change_count() const noexcept { return change_count_; }
  /// The message that entered last among the active ones, or nullptr.
  const FaultEntry* most_recent() const noexcept;
  /// Bits of the error register 1001h.
  std::uint8_t error_register() const noexcept;

  /// Fault 0..63 of the fault buffer: eight cases of eight, the current one first.
  BufferEntry fault(std::size_t index) const noexcept;
  /// Alarm 0..63 of the alarm buffer.
  const BufferEntry& alarm(std::size_t index) const noexcept { return alarm_buffer_.at(index); }
  /// How often the buffers were filled and changed since they were cleared.
  struct Counters {
    std::uint16_t fault_changes = 0;  ///< r0944
    std::uint16_t fault_cases = 0;    ///< p0952
    std::uint16_t alarm_changes = 0;  ///< r2121
    std::uint16_t alarms = 0;         ///< p2111
  };
  const Counters& counters() const noexcept { return counters_; }
  /// How often a message has entered since the memory was made.
  struct Entered {
    std::uint32_t as_fault = 0;
    std::uint32_t as_alarm = 0;
  };
  /// In the order of fault_rows().
  std::span<const Entered> entered() const noexcept;
  /// p0952 = 0: the buffer holds only what is active.
  void clear_fault_buffer() noexcept;
  /// What survives a power cut.
  struct Kept {
    static constexpr std::size_t kFaults = 64;
    std::uint16_t fault_changes = 0;            ///< r0944
    std::uint16_t fault_cases = 0;              ///< p0952
    std::array<BufferEntry, kFaults> faults{};  ///< as fault() shows them
  };
  Kept kept() const noexcept;
  /// Takes over what a former life kept; a case that was active then has ended at @p power_off.
  void bring_back(const Kept& kept, const TimeStamp& power_off) noexcept;
  /// p2111 = 0: latched alarms leave, the buffer holds only what is active.
  void clear_alarm_buffer() noexcept;

  /// What is made of messages other than the table says; it holds for messages to come.
  MessageSettings settings{};

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

  FaultEntry* find(const FaultRow& row) noexcept;
  void update(FaultEntry& active, std::uint32_t value, Cause cause) noexcept;
  void note_entered(const FaultEntry& entry) noexcept;
  TimeStamp stamp() const noexcept { return (common_time_ != nullptr ? *common_time_ : own_time_).stamp(); }
  template <class Predicate>
  void remove_faults(Predicate leave) noexcept;

  List faults_;
  List alarms_;
  FaultHistory history_;
  AlarmBuffer alarm_buffer_;
  Counters counters_;
  std::array<Entered, kMostFaultRows> entered_{};
  TimeLine own_time_{};
  const TimeLine* common_time_ = nullptr;
  std::uint32_t sequence_ = 0;
  std::uint32_t* common_sequence_ = nullptr;
  std::uint32_t change_count_ = 0;
};

}  // namespace drive
