#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "eds/sheet/data_sheet.hpp"
#include "eds/sheet/names.hpp"

namespace conformance {

/// What the EDS says of an entry, for the node-ID that is tested.
struct EntryFacts {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::string name{};
  const eds::DataTypeRow* type = nullptr;  ///< null where the data type is none of CiA 301's simple ones
  canopen::Access access = canopen::Access::ReadWrite;
  bool mappable = false;
  bool no_write = false;  ///< ObjFlags bit 0: is not to be written on download
  bool no_read = false;   ///< ObjFlags bit 1: is not to be read on scan
  std::optional<eds::Value> low{}, high{}, initial{};

  [[nodiscard]] bool readable() const noexcept { return access != canopen::Access::WriteOnly; }
  [[nodiscard]] bool writable() const noexcept {
    return access != canopen::Access::ReadOnly && access != canopen::Access::Constant;
  }
  /// True for a number of at most eight bytes.
  [[nodiscard]] bool numeric() const noexcept { return type != nullptr && type->bits != 0; }
  /// Length of a value in bytes; 0 for strings and DOMAIN, and where the type is unknown.
  [[nodiscard]] std::size_t bytes() const noexcept {
    return type == nullptr ? 0 : (static_cast<std::size_t>(type->bits) + 7) / 8;
  }
};

/// What the EDS files say of the device.
struct DeviceFacts {
  std::optional<std::uint64_t> vendor{}, product{}, revision{};
  std::string name{};
  std::uint64_t granularity = 0;  ///< of PDO mappings in bits; 0: mappings are fixed
  bool lss = false;
  bool dynamic_dummies = false;
  std::uint8_t dummy_types = 0;  ///< bit n: DummyUsage allows the type 000nh
};

/// Everything the EDS files say, for the checks.
class Description {
 public:
  /// Nothing is known of the node.
  Description() = default;
  /// Takes over @p sheet for the node @p node_id; what an earlier file has said of an entry stays.
  void add(const eds::DataSheet& sheet, std::uint8_t node_id);

  [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
  [[nodiscard]] const DeviceFacts& device() const noexcept { return device_; }
  [[nodiscard]] std::uint8_t node_id() const noexcept { return node_id_; }
  [[nodiscard]] bool has(std::uint16_t index) const noexcept { return objects_.contains(index); }
  /// The entry, or null.
  [[nodiscard]] const EntryFacts* find(std::uint16_t index, std::uint8_t sub_index = 0) const noexcept;
  /// Every entry, ascending.
  [[nodiscard]] std::span<const EntryFacts> entries() const noexcept { return entries_; }
  /// Every entry of an object.
  [[nodiscard]] std::span<const EntryFacts> entries_of(std::uint16_t index) const noexcept;
  /// Object code of @p index; Null where there is no such object.
  [[nodiscard]] eds::ObjectCode code_of(std::uint16_t index) const noexcept;
  /// Indices from @p first to @p last that exist.
  [[nodiscard]] std::vector<std::uint16_t> objects_within(std::uint16_t first, std::uint16_t last) const;

 private:
  std::uint8_t node_id_ = 1;
  DeviceFacts device_{};
  std::vector<EntryFacts> entries_;
  std::map<std::uint16_t, eds::ObjectCode> objects_;
};

/// @p value as the bytes of @p type on the node @p node_id; nothing for a value that the type cannot hold.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> encode(const eds::Value& value,
                                                              const eds::DataTypeRow& type, std::uint8_t node_id);
/// Bytes of an integer or REAL type as the value that an EDS would state.
[[nodiscard]] eds::Value decode(std::span<const std::uint8_t> bytes, const eds::DataTypeRow& type);
/// The low @p size bytes of @p number, least significant first.
[[nodiscard]] std::vector<std::uint8_t> little_endian(std::uint64_t number, std::size_t size);

}  // namespace conformance
