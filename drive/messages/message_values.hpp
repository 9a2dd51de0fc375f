#pragma once

#include <cstddef>

namespace drive {
class FaultMemory;
}

/// What parameters show and set of the faults and alarms of a drive object; times in ms of a day, days from 0.
namespace drive::message_value {

double fault_changes(const FaultMemory& memory, std::size_t index) noexcept;
double fault_cases(const FaultMemory& memory, std::size_t index) noexcept;
double fault_code(const FaultMemory& memory, std::size_t index) noexcept;
double fault_value(const FaultMemory& memory, std::size_t index) noexcept;
double fault_time(const FaultMemory& memory, std::size_t index) noexcept;
double fault_days(const FaultMemory& memory, std::size_t index) noexcept;
double fault_removed(const FaultMemory& memory, std::size_t index) noexcept;
double fault_removed_days(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_changes(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_count(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_code(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_value(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_time(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_days(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_removed(const FaultMemory& memory, std::size_t index) noexcept;
double alarm_removed_days(const FaultMemory& memory, std::size_t index) noexcept;
double newest_fault(const FaultMemory& memory, std::size_t index) noexcept;
double newest_alarm(const FaultMemory& memory, std::size_t index) noexcept;
double message_status(const FaultMemory& memory, std::size_t index) noexcept;
/// r2135: motor and power unit too warm.
double thermal_status(const FaultMemory& memory, std::size_t index) noexcept;
/// r3113: a bit for each class of messages.
double namur_bits(const FaultMemory& memory, std::size_t index) noexcept;
double reaction_number(const FaultMemory& memory, std::size_t index) noexcept;
double reaction(const FaultMemory& memory, std::size_t index) noexcept;
double type_number(const FaultMemory& memory, std::size_t index) noexcept;
double type(const FaultMemory& memory, std::size_t index) noexcept;

void clear_faults(FaultMemory& memory, std::size_t index, double value) noexcept;
void clear_alarms(FaultMemory& memory, std::size_t index, double value) noexcept;
void set_reaction_number(FaultMemory& memory, std::size_t index, double value) noexcept;
void set_reaction(FaultMemory& memory, std::size_t index, double value) noexcept;
void set_type_number(FaultMemory& memory, std::size_t index, double value) noexcept;
void set_type(FaultMemory& memory, std::size_t index, double value) noexcept;

}  // namespace drive::message_value
