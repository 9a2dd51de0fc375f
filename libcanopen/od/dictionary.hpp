#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/node_id.hpp"
#include "libcanopen/od/domain_owner.hpp"
#include "libcanopen/od/entry.hpp"

namespace canopen {

/// A typed view of one entry's value, for the owner's own use in the hot path. Valid as long as the dictionary.
template <class T>
class Cell {
 public:
  explicit Cell(std::byte* at) noexcept : at_{at} {}
  /// The value as it stands.
  T get() const noexcept { return load<T>(at_); }
  /// Sets the value without asking anybody.
  void set(T value) noexcept { store(at_, value); }

 private:
  std::byte* at_;
};

/// Who registers for an entry: the application is asked before the service of the node that works with the entry,
/// so that a service never acts on what the application refuses.
enum class OwnerRank : std::uint8_t { Application, Service };

/// The object dictionary of one node (CiA 301, 7.4): a table of entries and one flat image of their values.
/// Lookup costs two loads; after construction nothing is allocated.
class CANOPEN_EXPORT Dictionary {
 public:
  /// Builds the dictionary of @p table, sorted by index and sub-index without duplicates, for @p node_id 1..127
  /// or kNoNodeId.
  /// @p table must outlive the dictionary. Throws std::invalid_argument if the table is not in order.
  Dictionary(std::span<const EntryDescription> table, std::uint8_t node_id);
  ~Dictionary() = default;
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  /// The entry @p index, @p sub_index; nullptr if there is none.
  const Entry* lookup(std::uint16_t index, std::uint8_t sub_index) const noexcept {
    const Slot place = slot(index);
    if (sub_index < place.count) {
      const Entry* const expected = entries_.data() + place.first + sub_index;
      if (expected->sub_index == sub_index) return expected;
    }
    return search(place, sub_index);
  }
  /// Why lookup() of @p index finds nothing: NoObject or NoSubIndex.
  AbortCode absence(std::uint16_t index) const noexcept {
    return contains(index) ? AbortCode::NoSubIndex : AbortCode::NoObject;
  }
  /// The entry @p index, @p sub_index; NoObject or NoSubIndex.
  Result<const Entry*> find(std::uint16_t index, std::uint8_t sub_index) const noexcept {
    if (const Entry* const found = lookup(index, sub_index)) return found;
    return refuse(absence(index));
  }
  /// True if any entry of @p index exists.
  bool contains(std::uint16_t index) const noexcept { return slot(index).count != 0; }
  /// Every entry, in order.
  std::span<const Entry> entries() const noexcept { return entries_; }

  /// Reads a number as a master would see it; asks the owner. WriteOnly, UnsupportedAccess for a string.
  Result<std::int64_t> read(const Entry& entry) const {
    if (!entry.readable) return refuse(AbortCode::WriteOnly);
    if (entry.size == 0) return refuse(AbortCode::UnsupportedAccess);
    return entry.read_owner != nullptr ? entry.read_owner->read(entry, stored(entry)) : stored(entry);
  }
  /// May a master write @p value to a number, as far as its owner is not concerned? ReadOnly, ValueTooHigh,
  /// ValueTooLow, UnsupportedAccess for a string.
  static Result<void> check(const Entry& entry, std::int64_t value) noexcept;
  /// Writes a number as a master would: check(), then all owners, the services of a node among them. The refusal
  /// of either.
  Result<void> write(const Entry& entry, std::int64_t value);
  /// Reads a string as a master would see it; asks the owner. WriteOnly, UnsupportedAccess for a number.
  Result<std::span<const std::uint8_t>> read_text(const Entry& entry) const;
  /// The stored bytes of a string, without asking the owner.
  std::span<const std::uint8_t> text(const Entry& entry) const noexcept;
  /// Replaces the bytes of a string as a master would: access, capacity, then the owner. ReadOnly, LengthMismatch.
  Result<void> write_text(const Entry& entry, std::span<const std::uint8_t> text);

  /// The stored number of @p entry, without asking the owner.
  std::int64_t stored(const Entry& entry) const noexcept {
    const auto bits = load<std::uint64_t>(image_.data() + entry.offset);
    return entry.is_signed ? sign_extend(bits, entry.size) : static_cast<std::int64_t>(bits);
  }
  /// The stored number of an entry that need not exist.
  std::optional<std::int64_t> stored(std::uint16_t index, std::uint8_t sub_index) const noexcept {
    const Entry* const entry = lookup(index, sub_index);
    return entry != nullptr ? std::optional{stored(*entry)} : std::nullopt;
  }
  /// Stores a number without asking anybody.
  void set(const Entry& entry, std::int64_t value) noexcept {
    store(image_.data() + entry.offset, static_cast<std::uint64_t>(value) & byte_mask(entry.size));
  }
  /// Initial values again for the objects @p first to @p last, without asking the owners.
  void restore(std::uint16_t first, std::uint16_t last) noexcept;

  /// Registers @p owner for reads of one entry; the application's counts if a service owns it too. Throws
  /// std::out_of_range if there is no such entry. To be called before the node starts, as all of these.
  void own_read(std::uint16_t index, std::uint8_t sub_index, EntryOwner& owner,
                OwnerRank rank = OwnerRank::Application);
  /// Registers @p owner for writes of one entry, besides those that own it already: all have to agree, a service
  /// of the node last. Throws std::out_of_range if there is no such entry.
  void own_write(std::uint16_t index, std::uint8_t sub_index, EntryOwner& owner,
                 OwnerRank rank = OwnerRank::Application);
  /// Registers @p service of the node for writes of an entry, if that exists and can be written.
  void serve_writes(std::uint16_t index, std::uint8_t sub_index, EntryOwner& service);
  /// Registers @p owner for writes of one number as own_write() does, and makes these writes commands: what is
  /// written is never stored, so that the entry reads as before. Throws std::out_of_range if there is no such
  /// entry, std::invalid_argument if it is a string or DOMAIN.
  void own_command(std::uint16_t index, std::uint8_t sub_index, EntryOwner& owner,
                   OwnerRank rank = OwnerRank::Application);
  /// Registers @p owner for the data of a DOMAIN; an EntryOwner is not asked then. Throws std::out_of_range if
  /// there is no such entry, std::invalid_argument if it is of another type.
  void own_domain(std::uint16_t index, std::uint8_t sub_index, DomainOwner& owner);

  /// A view of a number. Throws std::out_of_range if there is no such entry, std::invalid_argument if its size
  /// is not that of T.
  template <class T>
  Cell<T> cell(std::uint16_t index, std::uint8_t sub_index) {
    return Cell<T>{checked_value(index, sub_index, sizeof(T))};
  }

  /// The values, for compiled PDO mappings. Every number takes eight bytes, the unused ones 0.
  std::byte* image() noexcept { return image_.data(); }
  const std::byte* image() const noexcept { return image_.data(); }

  /// Length of the longest value, in bytes.
  std::size_t longest_value() const noexcept { return longest_value_; }
  std::uint8_t node_id() const noexcept { return node_id_; }
  /// Another node-ID, 1..127 or kNoNodeId. Values relative to it follow when they are restored.
  void set_node_id(std::uint8_t node_id) noexcept { node_id_ = node_id; }
  /// The initial value of a number: that of its description, plus the node-ID if it is relative to that and there
  /// is one.
  std::int64_t initial(const Entry& entry) const noexcept {
    const bool relative = entry.description->node_relative && node_id_ != kNoNodeId;
    return entry.description->initial + (relative ? node_id_ : 0);
  }

 private:
  struct Slot {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  static constexpr std::uint32_t kPage = 256;  ///< slots for the indices that share their upper byte

  const Slot& slot(std::uint16_t index) const noexcept { return slots_[page_of_[index >> 8] + (index & 0xFF)]; }
  const Entry* search(Slot place, std::uint8_t sub_index) const noexcept;
  Entry& existing(std::uint16_t index, std::uint8_t sub_index);
  std::byte* checked_value(std::uint16_t index, std::uint8_t sub_index, std::size_t size);
  void append(const EntryDescription& row);
  void restore(const Entry& entry) noexcept;

  std::vector<Entry> entries_;
  std::array<std::uint32_t, 256> page_of_{};  ///< first slot of the page of an upper byte
  std::vector<Slot> slots_;
  std::vector<std::byte> image_;
  std::vector<std::unique_ptr<EntryOwner>> joint_owners_;
  std::size_t longest_value_ = 8;
  std::uint8_t node_id_;
};

}  // namespace canopen
