#include "libcanopen/od/dictionary.hpp"

#include <algorithm>
#include <stdexcept>

namespace canopen {
namespace {

constexpr bool readable(Access access) noexcept {
  return access != Access::WriteOnly;
}
constexpr bool writable(Access access) noexcept {
  return access != Access::ReadOnly && access != Access::Constant;
}
constexpr bool receives(Access access) noexcept {
  return access == Access::WriteOnly || access == Access::ReadWrite || access == Access::ReadWriteWrite;
}
constexpr bool transmits(Access access) noexcept {
  return access == Access::ReadOnly || access == Access::ReadWrite || access == Access::ReadWriteRead;
}

/// What a number takes in the image, whatever its type: one load or store reaches all of it.
constexpr std::size_t kNumberBytes = 8;

constexpr std::uint32_t key(const EntryDescription& row) noexcept {
  return std::uint32_t{row.index} << 8 | row.sub_index;
}

constexpr ValueOrder order_of(DataType type) noexcept {
  switch (type) {
    case DataType::Unsigned64:
      return ValueOrder::Unsigned64;
    case DataType::Real32:
      return ValueOrder::Real32;
    case DataType::Real64:
      return ValueOrder::Real64;
    default:
      return ValueOrder::Integer;
  }
}

/// A number that orders as the values do; the stored patterns of UNSIGNED64 and REAL do not.
constexpr std::int64_t rank(ValueOrder order, std::int64_t value) noexcept {
  switch (order) {
    case ValueOrder::Integer:
      return value;
    case ValueOrder::Unsigned64:
      return value ^ INT64_MIN;
    case ValueOrder::Real32: {
      const std::int64_t pattern = static_cast<std::int32_t>(value);
      return pattern < 0 ? INT32_MIN - pattern : pattern;
    }
    case ValueOrder::Real64:
      return value < 0 ? INT64_MIN - value : value;
  }
  return value;
}

void set_limits(Entry& entry, const EntryDescription& row) noexcept {
  const bool is_boolean = row.type == DataType::Boolean;  // 0 or 1, whatever the table says
  entry.limited = is_boolean || (row.limit_check == LimitCheck::Table && (row.low || row.high));
  entry.low = row.low ? rank(entry.order, *row.low) : is_boolean ? 0 : INT64_MIN;
  entry.high = row.high ? rank(entry.order, *row.high) : is_boolean ? 1 : INT64_MAX;
}

Entry entry_of(const EntryDescription& row) noexcept {
  const std::uint8_t size = size_of(row.type);
  const bool mappable = row.pdo_mappable && size != 0;
  Entry entry{
      .index = row.index,
      .sub_index = row.sub_index,
      .size = size,
      .readable = readable(row.access),
      .writable = writable(row.access),
      .receive_mappable = mappable && receives(row.access),
      .transmit_mappable = mappable && transmits(row.access),
      .is_signed = is_signed(row.type),
      .order = order_of(row.type),
      .bits = row.type == DataType::Boolean ? std::uint8_t{1} : static_cast<std::uint8_t>(8 * size),
      .description = &row,
  };
  set_limits(entry, row);
  return entry;
}

/// Two owners of the writes of one entry: both have to agree, the first one is asked first.
class JointOwner final : public EntryOwner {
 public:
  JointOwner(EntryOwner& first, EntryOwner& second) noexcept : first_{first}, second_{second} {}
  Result<void> write(const Entry& entry, std::int64_t value) override {
    const auto accepted = first_.write(entry, value);
    return accepted ? second_.write(entry, value) : accepted;
  }
  Result<void> write_text(const Entry& entry, std::span<const std::uint8_t> text) override {
    const auto accepted = first_.write_text(entry, text);
    return accepted ? second_.write_text(entry, text) : accepted;
  }

 private:
  EntryOwner& first_;
  EntryOwner& second_;
};

}  // namespace

Dictionary::Dictionary(std::span<const EntryDescription> table, std::uint8_t node_id) : node_id_{node_id} {
  const auto out_of_order = [](const auto& a, const auto& b) { return key(a) >= key(b); };
  if (std::adjacent_find(table.begin(), table.end(), out_of_order) != table.end()) {
    throw std::invalid_argument{
        "the table of a dictionary must be sorted by index and sub-index, without duplicates"};
  }
  entries_.reserve(table.size());
  slots_.resize(kPage);  // the first page stays empty: every index without a page of its own looks there
  for (const EntryDescription& row : table) append(row);
  restore(0, 0xFFFF);
}

void Dictionary::append(const EntryDescription& row) {
  Entry entry = entry_of(row);
  const std::size_t capacity = std::max<std::size_t>(row.capacity, row.text.size());
  const std::size_t bytes = entry.size != 0 ? kNumberBytes : sizeof(std::uint32_t) + capacity;
  const std::size_t offset = (image_.size() + kNumberBytes - 1) / kNumberBytes * kNumberBytes;
  image_.resize(offset + bytes);
  longest_value_ = std::max(longest_value_, capacity);
  entry.offset = static_cast<std::uint32_t>(offset);

  std::uint32_t& page = page_of_[row.index >> 8];
  if (page == 0) {
    page = static_cast<std::uint32_t>(slots_.size());
    slots_.resize(slots_.size() + kPage);
  }
  Slot& slot = slots_[page + (row.index & 0xFF)];
  if (slot.count == 0) slot.first = static_cast<std::uint32_t>(entries_.size());
  ++slot.count;
  entries_.push_back(entry);
}

/// What lookup() does where an object has gaps between its sub-indices.
const Entry* Dictionary::search(Slot place, std::uint8_t sub_index) const noexcept {
  const Entry* const first = entries_.data() + place.first;
  const Entry* const end = first + place.count;
  const Entry* const found = std::find_if(first, end, [=](const Entry& e) { return e.sub_index == sub_index; });
  return found != end ? found : nullptr;
}

Result<void> Dictionary::check(const Entry& entry, std::int64_t value) noexcept {
  if (!entry.writable) return refuse(AbortCode::ReadOnly);
  if (entry.size == 0) return refuse(AbortCode::UnsupportedAccess);
  if (entry.limited) {
    const std::int64_t place = rank(entry.order, value);
    if (place > entry.high) return refuse(AbortCode::ValueTooHigh);
    if (place < entry.low) return refuse(AbortCode::ValueTooLow);
  }
  return {};
}

Result<void> Dictionary::write(const Entry& entry, std::int64_t value) {
  if (auto allowed = check(entry, value); !allowed) return allowed;
  if (entry.write_owner != nullptr) {
    if (auto accepted = entry.write_owner->write(entry, value); !accepted) return accepted;
  }
  if (!entry.is_command) set(entry, value);
  return {};
}

Result<std::span<const std::uint8_t>> Dictionary::read_text(const Entry& entry) const {
  if (!entry.readable) return refuse(AbortCode::WriteOnly);
  if (entry.size != 0) return refuse(AbortCode::UnsupportedAccess);
  return entry.read_owner != nullptr ? entry.read_owner->read_text(entry, text(entry)) : text(entry);
}

std::span<const std::uint8_t> Dictionary::text(const Entry& entry) const noexcept {
  const std::byte* const at = image_.data() + entry.offset;
  return {reinterpret_cast<const std::uint8_t*>(at + sizeof(std::uint32_t)), load<std::uint32_t>(at)};
}

Result<void> Dictionary::write_text(const Entry& entry, std::span<const std::uint8_t> text) {
  if (!entry.writable) return refuse(AbortCode::ReadOnly);
  if (entry.size != 0) return refuse(AbortCode::UnsupportedAccess);
  if (text.size() > entry.description->capacity) return refuse(AbortCode::LengthMismatch);
  if (entry.write_owner != nullptr) {
    if (auto accepted = entry.write_owner->write_text(entry, text); !accepted) return accepted;
  }
  std::byte* const at = image_.data() + entry.offset;
  store(at, static_cast<std::uint32_t>(text.size()));
  std::copy(text.begin(), text.end(), reinterpret_cast<std::uint8_t*>(at + sizeof(std::uint32_t)));
  return {};
}

void Dictionary::restore(std::uint16_t first, std::uint16_t last) noexcept {
  for (const Entry& entry : entries_) {
    if (entry.index >= first && entry.index <= last) restore(entry);
  }
}

void Dictionary::restore(const Entry& entry) noexcept {
  if (entry.size != 0) return set(entry, initial(entry));
  const EntryDescription& row = *entry.description;
  std::byte* const at = image_.data() + entry.offset;
  store(at, static_cast<std::uint32_t>(row.text.size()));
  std::copy(row.text.begin(), row.text.end(), reinterpret_cast<char*>(at + sizeof(std::uint32_t)));
}

Entry& Dictionary::existing(std::uint16_t index, std::uint8_t sub_index) {
  const auto found = find(index, sub_index);
  if (!found) throw std::out_of_range{"the dictionary has no such entry"};
  return entries_[static_cast<std::size_t>(*found - entries_.data())];
}

void Dictionary::own_read(std::uint16_t index, std::uint8_t sub_index, EntryOwner& owner, OwnerRank rank) {
  Entry& entry = existing(index, sub_index);
  if (rank == OwnerRank::Application || entry.read_owner == nullptr) entry.read_owner = &owner;
}

void Dictionary::own_write(std::uint16_t index, std::uint8_t sub_index, EntryOwner& owner, OwnerRank rank) {
  Entry& entry = existing(index, sub_index);
  if (entry.write_owner == nullptr) {
    entry.write_owner = &owner;
    return;
  }
  EntryOwner& other = *entry.write_owner;
  const bool is_first = rank == OwnerRank::Application;
  joint_owners_.push_back(std::make_unique<JointOwner>(is_first ? owner : other, is_first ? other : owner));
  entry.write_owner = joint_owners_.back().get();
}

void Dictionary::serve_writes(std::uint16_t index, std::uint8_t sub_index, EntryOwner& service) {
  const Entry* const entry = lookup(index, sub_index);
  if (entry != nullptr && entry->writable) own_write(index, sub_index, service, OwnerRank::Service);
}

void Dictionary::own_command(std::uint16_t index, std::uint8_t sub_index, EntryOwner& owner, OwnerRank rank) {
  Entry& entry = existing(index, sub_index);
  if (entry.size == 0) throw std::invalid_argument{"a command is a number"};
  own_write(index, sub_index, owner, rank);
  entry.is_command = true;
}

void Dictionary::own_domain(std::uint16_t index, std::uint8_t sub_index, DomainOwner& owner) {
  Entry& entry = existing(index, sub_index);
  if (entry.description->type != DataType::Domain) throw std::invalid_argument{"the entry is no DOMAIN"};
  entry.domain = &owner;
}

std::byte* Dictionary::checked_value(std::uint16_t index, std::uint8_t sub_index, std::size_t size) {
  const Entry& entry = existing(index, sub_index);
  if (entry.size != size) throw std::invalid_argument{"the entry has another size"};
  return image_.data() + entry.offset;
}

}  // namespace canopen
