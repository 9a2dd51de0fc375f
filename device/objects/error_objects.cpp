#include "device/objects/error_objects.hpp"

#include <algorithm>

#include "device/objects/object_index.hpp"

namespace device {
namespace {

// Layout of 1003h (p8611): the sum, the most recent message, then a count and eight entries for each of eight
// logical modules and for the control unit.
constexpr unsigned kCount = 0x00;
constexpr unsigned kMostRecent = 0x01;
constexpr unsigned kFirstModule = 0x02;
constexpr unsigned kControlUnit = 0x4A;
constexpr unsigned kEntriesEach = 8;

/// Of 1001h: a fault outside the communication.
constexpr unsigned kManufacturerBit = 0x80;
/// Sub-index of 1029h for such faults.
constexpr std::uint8_t kDeviceErrorClass = canopen::kCommunicationErrorClass + 1;

/// Sub-index of the count of messages of block @p block: 0 what is no logical module, then the modules. The
/// entries follow it.
constexpr unsigned begin_of(std::size_t block) noexcept {
  if (block == 0) return kControlUnit;
  return kFirstModule + (1 + kEntriesEach) * (static_cast<unsigned>(block) - 1);
}

/// The block that has the messages of drive object @p object of @p unit: an infeed is no logical module.
std::size_t block_of(const drive::DriveUnit& unit, std::uint8_t object) noexcept {
  return object < unit.first_axis() ? 0U : 1U + object - unit.first_axis();
}

/// An alarm of the communication comes from the unit as a whole and is reported once, for the control unit.
bool is_of_the_unit(const drive::FaultEntry& entry) noexcept {
  return entry.kind == drive::Kind::Alarm && entry.emcy_code() != 0;
}

constexpr std::uint32_t field(std::uint16_t code, std::uint16_t high_word) noexcept {
  return std::uint32_t{high_word} << 16 | code;
}

}  // namespace

ErrorObjects::ErrorObjects(canopen::Dictionary& dictionary, const drive::DriveUnit& unit)
    : dictionary_{dictionary},
      unit_{unit},
      error_register_{dictionary.cell<std::uint8_t>(object::kErrorRegister, 0)} {
  dictionary.own_read(object::kErrorField, kCount, *this);
}

canopen::Result<std::int64_t> ErrorObjects::read(const canopen::Entry&, std::int64_t) {
  return entries_;
}

void ErrorObjects::update(canopen::Node& node, bool changed) noexcept {
  if (!changed && !stale_) return;
  stale_ = false;
  error_register_.set(error_register());
  const Messages active = messages();
  fill(active);
  if (bus_off_) return;
  const bool device_fault = report(active, node);
  if (told_ && entries_ == 0) node.send_emcy(0, error_register_.get(), {});
  told_ = entries_ != 0;
  if (device_fault) node.apply_error_behaviour(kDeviceErrorClass);
}

void ErrorObjects::set_bus_off(bool off) noexcept {
  bus_off_ = off;
  stale_ = true;
}

std::uint8_t ErrorObjects::error_register() const noexcept {
  unsigned bits = 0;
  unit_.for_each_object([&](const drive::DriveObject& object) { bits |= object.messages().error_register(); });
  return static_cast<std::uint8_t>(bits);
}

void ErrorObjects::Messages::add(const drive::FaultEntry& entry, std::uint8_t object) noexcept {
  if (entry.emcy_code() == 0) return;
  const bool once = is_of_the_unit(entry);
  const auto same = [&](const Reported& other) {
    return is_of_the_unit(*other.entry) && other.entry->row->number == entry.row->number;
  };
  if (once && std::ranges::any_of(all(), same)) return;
  items[count++] = {&entry, once ? drive::kControlUnitNumber : object};
}

ErrorObjects::Messages ErrorObjects::messages() const noexcept {
  Messages found;
  unit_.for_each_object([&](const drive::DriveObject& object) {
    for (const drive::FaultEntry& entry : object.messages().faults()) found.add(entry, object.number());
    for (const drive::FaultEntry& entry : object.messages().alarms()) found.add(entry, object.number());
  });
  std::sort(found.items.begin(), found.items.begin() + found.count,
            [](const Reported& a, const Reported& b) { return a.entry->sequence < b.entry->sequence; });
  return found;
}

void ErrorObjects::fill(const Messages& messages) noexcept {
  std::array<unsigned, 1 + drive::kMostAxes> counts{};
  for (const auto& [entry, object] : messages.all()) {
    const std::size_t block = block_of(unit_, object);
    unsigned& count = counts[block];
    if (count < kEntriesEach) set(begin_of(block) + ++count, field(entry->emcy_code(), entry->row->number));
  }
  entries_ = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const unsigned block = begin_of(i);
    set(block, counts[i]);
    for (unsigned unused = counts[i] + 1; unused <= kEntriesEach; ++unused) set(block + unused, 0);
    entries_ += counts[i];
  }
  set(kCount, entries_);
  const auto newest = messages.all();
  set(kMostRecent, newest.empty() ? 0 : field(newest.back().entry->emcy_code(), newest.back().object));
}

void ErrorObjects::set(unsigned sub_index, std::uint32_t value) noexcept {
  const auto entry = dictionary_.find(object::kErrorField, static_cast<std::uint8_t>(sub_index));
  if (entry) dictionary_.set(**entry, value);
}

/// True if a fault of a drive object is among what entered.
bool ErrorObjects::report(const Messages& messages, canopen::Node& node) noexcept {
  bool device_fault = false;
  for (const auto& [entry, object] : messages.all()) {
    if (entry->sequence <= seen_sequence_) continue;
    seen_sequence_ = entry->sequence;
    const std::uint16_t number = entry->row->number;
    const std::array<std::uint8_t, 5> bytes{static_cast<std::uint8_t>(number),
                                            static_cast<std::uint8_t>(number >> 8), object, 0, 0};
    node.send_emcy(entry->emcy_code(), error_register_.get(), bytes);
    device_fault = device_fault || (entry->error_register() & kManufacturerBit) != 0;
  }
  return device_fault;
}

}  // namespace device
