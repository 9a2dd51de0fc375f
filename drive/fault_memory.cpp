#include "drive/fault_memory.hpp"

#include <algorithm>

namespace drive {
namespace {

struct EmcyException {
  std::uint16_t number;
  std::uint32_t value;
  std::uint16_t emcy_code;
};
// Life guarding; bus-off (value 1) is "any other message of 8700..8799".
constexpr std::array kEmcyExceptions{EmcyException{8700, 2, 0x8130}};

}  // namespace

std::uint16_t FaultEntry::emcy_code() const noexcept {
  for (const EmcyException& exception : kEmcyExceptions)
    if (exception.number == row->number && exception.value == value) return exception.emcy_code;
  return row->emcy_code;
}

FaultEntry* FaultMemory::List::find(const FaultRow& row) noexcept {
  const auto end = items.begin() + static_cast<std::ptrdiff_t>(count);
  const auto found =
      std::find_if(items.begin(), end, [&](const FaultEntry& e) { return e.row->number == row.number; });
  return found != end ? &*found : nullptr;
}

template <class Predicate>
std::size_t FaultMemory::List::remove_if(Predicate leaves) noexcept {
  const auto end = items.begin() + static_cast<std::ptrdiff_t>(count);
  const auto kept = std::remove_if(items.begin(), end, leaves);
  const auto removed = static_cast<std::size_t>(end - kept);
  count -= removed;
  return removed;
}

void FaultMemory::enter(const FaultRow& row, std::uint32_t value, Cause cause) noexcept {
  List& list = list_of(row);
  if (FaultEntry* active = list.find(row)) {
    if (active->value != value) ++change_count_;
    active->value = value;
    active->cause = cause;
    return;
  }
  if (list.count == kCapacity) return;
  list.items[list.count++] = FaultEntry{&row, value, ++sequence_, cause};
  ++change_count_;
}

void FaultMemory::withdraw(const FaultRow& row) noexcept {
  List& list = list_of(row);
  FaultEntry* active = list.find(row);
  if (active == nullptr) return;
  active->cause = Cause::Gone;
  if (row.kind != Kind::Alarm) return;
  list.remove_if([&](const FaultEntry& e) { return e.row->number == row.number; });
  ++change_count_;
}

bool FaultMemory::acknowledge(bool pulses_enabled) noexcept {
  const auto may_leave = [&](const FaultEntry& entry) {
    if (entry.cause == Cause::Present || entry.row->acknowledge == Acknowledge::PowerOn) return false;
    return entry.row->acknowledge != Acknowledge::PulseInhibit || !pulses_enabled;
  };
  if (faults_.remove_if(may_leave) != 0) ++change_count_;
  return faults_.count == 0;
}

void FaultMemory::clear() noexcept {
  if (faults_.count + alarms_.count != 0) ++change_count_;
  faults_.count = 0;
  alarms_.count = 0;
}

const FaultEntry* FaultMemory::most_recent() const noexcept {
  const FaultEntry* fault = faults_.count != 0 ? &faults_.items[faults_.count - 1] : nullptr;
  const FaultEntry* alarm = alarms_.count != 0 ? &alarms_.items[alarms_.count - 1] : nullptr;
  if (fault == nullptr || alarm == nullptr) return fault != nullptr ? fault : alarm;
  return fault->sequence > alarm->sequence ? fault : alarm;
}

std::uint8_t FaultMemory::error_register() const noexcept {
  unsigned bits = 0;
  for (const FaultEntry& entry : faults()) bits |= entry.row->error_register;
  for (const FaultEntry& entry : alarms()) bits |= entry.row->error_register;
  return static_cast<std::uint8_t>(bits);
}

}  // namespace drive
