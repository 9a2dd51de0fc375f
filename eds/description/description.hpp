#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "eds/sheet/data_sheet.hpp"
#include "eds/sheet/names.hpp"

namespace eds {

/// What the EDS says of an entry, for the node-ID of the description.
struct EntryFacts {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::string name{};
  const DataTypeRow* type = nullptr;  ///< null where the data type is none of CiA 301's simple ones
  canopen::Access access = canopen::Access::ReadWrite;
  bool mappable = false;
  bool no_write = false;  ///< ObjFlags bit 0: is not to be written on download
  bool no_read = false;   ///< ObjFlags bit 1: is not to be read on scan
  std::optional<Value> low{}, high{}, initial{};

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

/// Everything the EDS files of a device say, to be looked up.
class Description {
 public:
  /// Nothing is known of the node.
  Description() = default;
  /// Nothing is known of the node @p node_id but that.
  explicit Description(std::uint8_t node_id) noexcept : node_id_{node_id} {}
  /// Takes over @p sheet for the node @p node_id; what an earlier file has said of an entry stays.
  void add(const DataSheet& sheet, std::uint8_t node_id);
  /// Takes over @p entry, unless it is known, of an object whose code is not.
  void add(EntryFacts entry);

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
  [[nodiscard]] ObjectCode code_of(std::uint16_t index) const noexcept;
  /// Indices from @p first to @p last that exist.
  [[nodiscard]] std::vector<std::uint16_t> objects_within(std::uint16_t first, std::uint16_t last) const;

 private:
  std::uint8_t node_id_ = 1;
  DeviceFacts device_{};
  std::vector<EntryFacts> entries_;
  std::map<std::uint16_t, ObjectCode> objects_;
};

/// What the EDS or DCF @p text says, called @p name in findings, of the node @p node_id; empty if it has no
/// object.
[[nodiscard]] Description read_description(const std::string& text, const std::string& name, std::uint8_t node_id);

/// @p value as the bytes of @p type on the node @p node_id; nothing for a value that the type cannot hold.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> encode(const Value& value, const DataTypeRow& type,
                                                              std::uint8_t node_id);
/// Bytes of an integer or REAL type as the value that an EDS would state.
[[nodiscard]] Value decode(std::span<const std::uint8_t> bytes, const DataTypeRow& type);
/// The low @p size bytes of @p number, least significant first.
[[nodiscard]] std::vector<std::uint8_t> little_endian(std::uint64_t number, std::size_t size);

}  // namespace eds
