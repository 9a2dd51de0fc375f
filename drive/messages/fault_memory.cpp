#include "drive/messages/fault_memory.hpp"

#include <algorithm>

namespace drive {
namespace {

constexpr std::uint16_t kGeneralError = 0x1000;
constexpr std::uint8_t kGenericBit = 0x01;
constexpr std::uint8_t kManufacturerBit = 0x80;

struct EmcyException {
  std::uint16_t number;
  std::uint32_t value;
  std::uint16_t emcy_code;
};
// Life guarding; bus-off (value 1) is "any other message of 8700..8799".
constexpr std::array kEmcyExceptions{EmcyException{8700, 2, 0x8130}};

/// Whether EMCY code and error register are those of the row whatever kind the message has.
bool is_of_the_communication(const FaultRow& row) noexcept {
  return row.number >= 8700 && row.number < 8800;
}

BufferEntry displayed(const FaultEntry& entry, const TimeStamp& removed) noexcept {
  return {entry.row->number, entry.value, entry.received, removed};
}

}  // namespace

std::uint16_t FaultEntry::emcy_code() const noexcept {
  for (const EmcyException& exception : kEmcyExceptions)
    if (exception.number == row->number && exception.value == value) return exception.emcy_code;
  if (is_of_the_communication(*row)) return row->emcy_code;
  return kind == Kind::Fault ? kGeneralError : std::uint16_t{0};
}

std::uint8_t FaultEntry::error_register() const noexcept {
  if (is_of_the_communication(*row)) return row->error_register;
  return kind == Kind::Fault ? kGenericBit | kManufacturerBit : 0;
}

Acknowledge FaultEntry::acknowledge() const noexcept {
  return row->kind == Kind::Fault ? row->acknowledge : Acknowledge::Immediately;
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

/// The active entry of @p row, whichever kind it had when it entered.
FaultEntry* FaultMemory::find(const FaultRow& row) noexcept {
  FaultEntry* const fault = faults_.find(row);
  return fault != nullptr ? fault : alarms_.find(row);
}

void FaultMemory::enter(const FaultRow& row, std::uint32_t value, Cause cause) noexcept {
  if (FaultEntry* const active = find(row)) return update(*active, value, cause);
  const std::optional<Kind> kind = settings.kind_of(row);
  if (!kind) return;
  List& list = *kind == Kind::Fault ? faults_ : alarms_;
  if (list.count == kCapacity) return;
  std::uint32_t& sequence = common_sequence_ != nullptr ? *common_sequence_ : sequence_;
  list.items[list.count++] = FaultEntry{&row, value, ++sequence, cause, *kind, stamp()};
  ++change_count_;
  note_entered(list.items[list.count - 1]);
}

void FaultMemory::update(FaultEntry& active, std::uint32_t value, Cause cause) noexcept {
  active.cause = cause;
  active.acknowledged = false;
  if (active.value == value) return;
  active.value = value;
  ++change_count_;
  if (active.kind == Kind::Alarm) alarm_buffer_.change(active.row->number, value);
}

std::span<const FaultMemory::Entered> FaultMemory::entered() const noexcept {
  return std::span{entered_}.first(fault_rows().size());
}

void FaultMemory::note_entered(const FaultEntry& entry) noexcept {
  Entered& times = entered_[static_cast<std::size_t>(entry.row - fault_rows().data())];
  ++(entry.kind == Kind::Alarm ? times.as_alarm : times.as_fault);
  if (entry.kind == Kind::Alarm) {
    alarm_buffer_.enter(entry.row->number, entry.value, entry.received);
    ++counters_.alarms;
    ++counters_.alarm_changes;
    return;
  }
  if (faults_.count == 1) ++counters_.fault_cases;
  ++counters_.fault_changes;
}

bool FaultMemory::withdraw(const FaultRow& row) noexcept {
  FaultEntry* const active = find(row);
  if (active == nullptr) return false;
  active->cause = Cause::Gone;
  const auto is_it = [&](const FaultEntry& entry) { return entry.row->number == row.number; };
  if (active->kind == Kind::Fault) {
    const bool leaves = active->acknowledged;
    if (leaves) remove_faults(is_it);
    return leaves;
  }
  alarms_.remove_if(is_it);
  alarm_buffer_.leave(row.number, stamp());
  ++counters_.alarm_changes;
  ++change_count_;
  return false;
}

/// Removes the faults that @p leave accepts and keeps them as a case of the buffer; what stays is a new case.
template <class Predicate>
void FaultMemory::remove_faults(Predicate leave) noexcept {
  std::array<BufferEntry, kCapacity> gone{};
  std::size_t count = 0;
  for (const FaultEntry& entry : faults())
    if (leave(entry)) gone[count++] = displayed(entry, stamp());
  if (count == 0) return;
  faults_.remove_if(leave);
  history_.push({gone.data(), count});
  if (faults_.count != 0) ++counters_.fault_cases;
  ++counters_.fault_changes;
  ++change_count_;
}

bool FaultMemory::acknowledge(bool pulses_enabled) noexcept {
  const auto may_leave = [=](const FaultEntry& entry) {
    const Acknowledge way = entry.acknowledge();
    if (entry.cause == Cause::Present || way == Acknowledge::PowerOn) return false;
    return way != Acknowledge::PulseInhibit || !pulses_enabled;
  };
  for (std::size_t i = 0; i < faults_.count; ++i) {
    FaultEntry& entry = faults_.items[i];
    entry.acknowledged = entry.cause == Cause::Ending && may_leave(entry);
  }
  remove_faults([&](const FaultEntry& entry) { return may_leave(entry) && !entry.acknowledged; });
  return faults_.count == 0;
}

void FaultMemory::clear() noexcept {
  remove_faults([](const FaultEntry&) { return true; });
  if (alarms_.count == 0) return;
  for (const FaultEntry& entry : alarms()) alarm_buffer_.leave(entry.row->number, stamp());
  alarms_.count = 0;
  ++counters_.alarm_changes;
  ++change_count_;
}

const FaultEntry* FaultMemory::most_recent() const noexcept {
  const FaultEntry* fault = faults_.count != 0 ? &faults_.items[faults_.count - 1] : nullptr;
  const FaultEntry* alarm = alarms_.count != 0 ? &alarms_.items[alarms_.count - 1] : nullptr;
  if (fault == nullptr || alarm == nullptr) return fault != nullptr ? fault : alarm;
  return fault->sequence > alarm->sequence ? fault : alarm;
}

std::uint8_t FaultMemory::error_register() const noexcept {
  unsigned bits = 0;
  for (const FaultEntry& entry : faults()) bits |= entry.error_register();
  for (const FaultEntry& entry : alarms()) bits |= entry.error_register();
  return static_cast<std::uint8_t>(bits);
}

BufferEntry FaultMemory::fault(std::size_t index) const noexcept {
  if (index >= kCapacity) return history_.at(index - kCapacity);
  return index < faults_.count ? displayed(faults_.items[index], {}) : BufferEntry{};
}

void FaultMemory::clear_fault_buffer() noexcept {
  history_.clear();
  counters_.fault_cases = 0;
  ++counters_.fault_changes;
  ++change_count_;
}

FaultMemory::Kept FaultMemory::kept() const noexcept {
  Kept kept{.fault_changes = counters_.fault_changes, .fault_cases = counters_.fault_cases};
  for (std::size_t i = 0; i < kept.faults.size(); ++i) kept.faults[i] = fault(i);
  return kept;
}

void FaultMemory::bring_back(const Kept& kept, const TimeStamp& power_off) noexcept {
  counters_.fault_changes = kept.fault_changes;
  counters_.fault_cases = kept.fault_cases;
  history_.assign(std::span{kept.faults}.subspan(kCapacity));
  std::array<BufferEntry, kCapacity> active{};
  std::copy_n(kept.faults.begin(), kCapacity, active.begin());
  if (active.front().number == 0) return;
  for (BufferEntry& entry : active)
    if (entry.number != 0) entry.removed = power_off;
  history_.push(active);
}

void FaultMemory::clear_alarm_buffer() noexcept {
  const auto is_latched = [](const FaultEntry& entry) { return entry.cause == Cause::Latched; };
  for (const FaultEntry& entry : alarms())
    if (is_latched(entry)) alarm_buffer_.leave(entry.row->number, stamp());
  if (alarms_.remove_if(is_latched) != 0) ++change_count_;
  alarm_buffer_.clear();
  counters_.alarms = 0;
  ++counters_.alarm_changes;
  ++change_count_;
}

}  // namespace drive
