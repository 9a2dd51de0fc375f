#include "drive/messages/message_values.hpp"

#include <cstdint>

#include "drive/messages/fault_memory.hpp"
#include "drive/messages/message_classes.hpp"

namespace drive::message_value {
namespace {

constexpr unsigned kFaultPresent = 1U << 3;
constexpr unsigned kAlarmPresent = 1U << 7;

double of_the_day(const TimeStamp& time) noexcept {
  return static_cast<double>(time.shown() % kMillisecondsOfADay);
}

double days(const TimeStamp& time) noexcept {
  return static_cast<double>(time.shown() / kMillisecondsOfADay % 0x10000U);
}

/// Fault and alarm values are shown as signed numbers.
double signed_value(const BufferEntry& entry) noexcept {
  return static_cast<double>(static_cast<std::int32_t>(entry.value));
}

template <class Visit>
void for_each_active(const FaultMemory& memory, const Visit& visit) {
  for (const auto entries : {memory.faults(), memory.alarms()})
    for (const FaultEntry& entry : entries) visit(entry);
}

double newest(std::span<const FaultEntry> entries) noexcept {
  return entries.empty() ? 0.0 : static_cast<double>(entries.back().row->number);
}

}  // namespace

double fault_changes(const FaultMemory& memory, std::size_t) noexcept {
  return memory.counters().fault_changes;
}
double fault_cases(const FaultMemory& memory, std::size_t) noexcept {
  return memory.counters().fault_cases;
}
double fault_code(const FaultMemory& memory, std::size_t index) noexcept {
  return memory.fault(index).number;
}
double fault_value(const FaultMemory& memory, std::size_t index) noexcept {
  return signed_value(memory.fault(index));
}
double fault_time(const FaultMemory& memory, std::size_t index) noexcept {
  return of_the_day(memory.fault(index).received);
}
double fault_days(const FaultMemory& memory, std::size_t index) noexcept {
  return days(memory.fault(index).received);
}
double fault_removed(const FaultMemory& memory, std::size_t index) noexcept {
  return of_the_day(memory.fault(index).removed);
}
double fault_removed_days(const FaultMemory& memory, std::size_t index) noexcept {
  return days(memory.fault(index).removed);
}
double alarm_changes(const FaultMemory& memory, std::size_t) noexcept {
  return memory.counters().alarm_changes;
}
double alarm_count(const FaultMemory& memory, std::size_t) noexcept {
  return memory.counters().alarms;
}
double alarm_code(const FaultMemory& memory, std::size_t index) noexcept {
  return memory.alarm(index).number;
}
double alarm_value(const FaultMemory& memory, std::size_t index) noexcept {
  return signed_value(memory.alarm(index));
}
double alarm_time(const FaultMemory& memory, std::size_t index) noexcept {
  return of_the_day(memory.alarm(index).received);
}
double alarm_days(const FaultMemory& memory, std::size_t index) noexcept {
  return days(memory.alarm(index).received);
}
double alarm_removed(const FaultMemory& memory, std::size_t index) noexcept {
  return of_the_day(memory.alarm(index).removed);
}
double alarm_removed_days(const FaultMemory& memory, std::size_t index) noexcept {
  return days(memory.alarm(index).removed);
}
double newest_fault(const FaultMemory& memory, std::size_t) noexcept {
  return newest(memory.faults());
}
double newest_alarm(const FaultMemory& memory, std::size_t) noexcept {
  return newest(memory.alarms());
}
double message_status(const FaultMemory& memory, std::size_t) noexcept {
  return (memory.faults().empty() ? 0U : kFaultPresent) | (memory.alarms().empty() ? 0U : kAlarmPresent);
}
double thermal_status(const FaultMemory& memory, std::size_t) noexcept {
  unsigned bits = 0;
  for_each_active(memory, [&](const FaultEntry& entry) { bits |= thermal_bit(entry.row->number, entry.kind); });
  return bits;
}
double namur_bits(const FaultMemory& memory, std::size_t) noexcept {
  unsigned bits = 0;
  for_each_active(memory, [&](const FaultEntry& entry) { bits |= namur_bit(entry.row->number); });
  return bits;
}
double reaction_number(const FaultMemory& memory, std::size_t index) noexcept {
  return memory.settings.reaction_numbers[index];
}
double reaction(const FaultMemory& memory, std::size_t index) noexcept {
  return memory.settings.reactions[index];
}
double type_number(const FaultMemory& memory, std::size_t index) noexcept {
  return memory.settings.type_numbers[index];
}
double type(const FaultMemory& memory, std::size_t index) noexcept {
  return memory.settings.types[index];
}

void clear_faults(FaultMemory& memory, std::size_t, double) noexcept {
  memory.clear_fault_buffer();
}
void clear_alarms(FaultMemory& memory, std::size_t, double) noexcept {
  memory.clear_alarm_buffer();
}
void set_reaction_number(FaultMemory& memory, std::size_t index, double value) noexcept {
  memory.settings.reaction_numbers[index] = static_cast<std::uint16_t>(value);
}
void set_reaction(FaultMemory& memory, std::size_t index, double value) noexcept {
  memory.settings.reactions[index] = static_cast<std::uint8_t>(value);
}
void set_type_number(FaultMemory& memory, std::size_t index, double value) noexcept {
  memory.settings.type_numbers[index] = static_cast<std::uint16_t>(value);
}
void set_type(FaultMemory& memory, std::size_t index, double value) noexcept {
  memory.settings.types[index] = static_cast<std::uint8_t>(value);
}

}  // namespace drive::message_value
