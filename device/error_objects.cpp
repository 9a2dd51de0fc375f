#include "device/error_objects.hpp"

#include <algorithm>
#include <array>

#include "device/object_index.hpp"

namespace device {
namespace {

// Layout of 1003h (p8611): the sum, the most recent message, then a count and eight entries for each logical
// module and for the control unit.
constexpr std::uint8_t kCount = 0x00;
constexpr std::uint8_t kMostRecent = 0x01;
constexpr std::uint8_t kControlUnitObject = 1;
constexpr std::uint32_t kEntriesEach = 8;

struct Block {
  std::uint8_t drive_object;
  std::uint8_t count;  ///< sub-index; the entries follow it
};
constexpr std::array kBlocks{Block{kFirstAxisObject, 0x02}, Block{kControlUnitObject, 0x4A}};

/// CAN messages come from the unit as a whole and are reported once, with the drive object number 1.
bool is_of_the_unit(const drive::FaultRow& row) noexcept {
  return row.kind == drive::Kind::Alarm && row.scope == drive::Scope::Both;
}

std::uint8_t drive_object(const drive::FaultRow& row) noexcept {
  return is_of_the_unit(row) ? kControlUnitObject : kFirstAxisObject;
}

constexpr std::uint32_t field(std::uint16_t code, std::uint16_t high_word) noexcept {
  return std::uint32_t{high_word} << 16 | code;
}

/// Calls @p visit for every active message in the order of its arrival; both lists are sorted by sequence.
template <class Visit>
void for_each_in_order(const drive::FaultMemory& messages, const Visit& visit) {
  auto fault = messages.faults().begin();
  auto alarm = messages.alarms().begin();
  while (fault != messages.faults().end() || alarm != messages.alarms().end()) {
    const bool fault_next = alarm == messages.alarms().end() ||
                            (fault != messages.faults().end() && fault->sequence < alarm->sequence);
    visit(fault_next ? *fault++ : *alarm++);
  }
}

}  // namespace

ErrorObjects::ErrorObjects(canopen::Dictionary& dictionary, drive::Axis& axis)
    : dictionary_{dictionary},
      axis_{axis},
      error_register_{dictionary.cell<std::uint8_t>(object::kErrorRegister, 0)} {
  dictionary.own_read(object::kErrorField, kCount, *this);
}

canopen::Result<std::int64_t> ErrorObjects::read(const canopen::Entry&, std::int64_t) {
  return entries_;
}

void ErrorObjects::update(canopen::Node& node) noexcept {
  const drive::FaultMemory& messages = axis_.messages();
  if (messages.change_count() == seen_change_) return;
  seen_change_ = messages.change_count();
  error_register_.set(messages.error_register());
  const bool had_entries = entries_ != 0;
  fill(messages);
  report(messages, node);
  if (had_entries && entries_ == 0) node.send_emcy(0, error_register_.get(), {});
}

void ErrorObjects::fill(const drive::FaultMemory& messages) noexcept {
  const drive::FaultEntry* most_recent = nullptr;
  entries_ = 0;
  for (const Block& block : kBlocks) {
    std::uint32_t count = 0;
    for_each_in_order(messages, [&](const drive::FaultEntry& entry) {
      if (!is_reported(entry) || drive_object(*entry.row) != block.drive_object) return;
      if (most_recent == nullptr || entry.sequence > most_recent->sequence) most_recent = &entry;
      if (count == kEntriesEach) return;
      set(static_cast<std::uint8_t>(block.count + ++count), field(entry.emcy_code(), entry.row->number));
    });
    set(block.count, count);
    for (std::uint32_t unused = count + 1; unused <= kEntriesEach; ++unused) {
      set(static_cast<std::uint8_t>(block.count + unused), 0);
    }
    entries_ += count;
  }
  set(kCount, entries_);
  const bool empty = most_recent == nullptr;
  set(kMostRecent, empty ? 0 : field(most_recent->emcy_code(), drive_object(*most_recent->row)));
}

void ErrorObjects::set(std::uint8_t sub_index, std::uint32_t value) noexcept {
  if (const auto entry = dictionary_.find(object::kErrorField, sub_index)) dictionary_.set(**entry, value);
}

void ErrorObjects::report(const drive::FaultMemory& messages, canopen::Node& node) noexcept {
  for_each_in_order(messages, [&](const drive::FaultEntry& entry) {
    if (entry.sequence <= seen_sequence_) return;
    seen_sequence_ = entry.sequence;
    if (!is_reported(entry)) return;
    const std::uint16_t number = entry.row->number;
    const std::array<std::uint8_t, 5> bytes{
        static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8), drive_object(*entry.row), 0, 0};
    node.send_emcy(entry.emcy_code(), error_register_.get(), bytes);
  });
}

}  // namespace device
