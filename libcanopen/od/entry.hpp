#pragma once

#include <cstdint>
#include <span>

#include "libcanopen/base/export.hpp"
#include "libcanopen/od/abort_code.hpp"
#include "libcanopen/od/entry_description.hpp"

namespace canopen {

class DomainOwner;
class EntryOwner;

/// How the values of an entry compare.
enum class ValueOrder : std::uint8_t { Integer, Unsigned64, Real32, Real64 };

/// One entry of a dictionary at run time: the facts of its description that an access needs, in one cache line.
struct alignas(64) Entry {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint8_t size = 0;  ///< bytes of a number, 0 for a string type or DOMAIN
  bool readable = false;
  bool writable = false;
  bool receive_mappable = false;   ///< may stand in an RPDO
  bool transmit_mappable = false;  ///< may stand in a TPDO
  bool is_signed = false;
  bool limited = false;  ///< the dictionary checks `low` and `high`
  ValueOrder order = ValueOrder::Integer;
  std::uint8_t bits = 0;     ///< of a number in a PDO: 1 for BOOLEAN, else eight for each byte
  std::uint32_t offset = 0;  ///< of the eight bytes of a number in the image; of the length word of a string
  EntryOwner* read_owner = nullptr;   ///< asked before a read, if any
  EntryOwner* write_owner = nullptr;  ///< asked before a write, if any
  DomainOwner* domain = nullptr;      ///< gives and takes the data of a DOMAIN, if any
  std::int64_t low = 0;   ///< in an order that holds for every type: not the raw pattern of UNSIGNED64 and REAL
  std::int64_t high = 0;  ///< likewise
  const EntryDescription* description = nullptr;
};
static_assert(sizeof(Entry) == 64);

/// What stands behind an entry. A service or the application registers itself for the entries whose reads or
/// writes mean more than memory; all others are plain values of the dictionary.
class CANOPEN_EXPORT EntryOwner {
 public:
  virtual ~EntryOwner() = default;
  /// Gives the value of the number @p entry, whose last known value is @p stored.
  virtual Result<std::int64_t> read(const Entry& entry, std::int64_t stored) {
    (void)entry;
    return stored;
  }
  /// Takes @p value, which has passed existence, access, length and limit checks. The dictionary stores the value
  /// after success; a refusal leaves everything as it was.
  virtual Result<void> write(const Entry& entry, std::int64_t value) {
    (void)entry, (void)value;
    return {};
  }
  /// Gives the bytes of the string @p entry, no more than its capacity; they must stay as they are during the call
  /// into the node that asks.
  virtual Result<std::span<const std::uint8_t>> read_text(const Entry& entry,
                                                          std::span<const std::uint8_t> stored) {
    (void)entry;
    return stored;
  }
  /// Takes the bytes of the string @p entry, no more than its capacity; otherwise as write().
  virtual Result<void> write_text(const Entry& entry, std::span<const std::uint8_t> text) {
    (void)entry, (void)text;
    return {};
  }
};

}  // namespace canopen
