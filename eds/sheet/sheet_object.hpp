#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "eds/document/value.hpp"
#include "eds/sheet/names.hpp"
#include "eds/sheet/stated.hpp"

namespace eds {

/// One entry of an object: what an index and a sub-index address. Points into the document.
struct SheetEntry {
  std::uint8_t sub_index = 0;
  bool compact = false;              ///< made from CompactSubObj: what it states stands in the object's section
  const Section* section = nullptr;  ///< that describes it
  std::string name{};                ///< ParameterName, or what CompactSubObj makes of it
  Stated<std::uint64_t> object_type{};
  Stated<std::uint64_t> data_type{};
  const DataTypeRow* type = nullptr;  ///< null where the data type is none of CiA 301's simple ones
  Stated<canopen::Access> access{};
  Stated<Value> low{};
  Stated<Value> high{};
  Stated<Value> default_value{};
  Stated<bool> mappable{};
  Stated<std::uint64_t> flags{};           ///< ObjFlags: bit 0 refuse write on download, bit 1 refuse read on scan
  Stated<Value> parameter_value{};         ///< of a DCF
  Stated<std::string_view> denotation{};   ///< of a DCF
  Stated<std::string_view> upload_file{};  ///< of a DCF: where a DOMAIN is read to
  Stated<std::string_view> download_file{};  ///< of a DCF: what a DOMAIN is written from

  /// The value that the node has after its configuration: that of a DCF, else the default.
  [[nodiscard]] const Stated<Value>& effective() const noexcept {
    return parameter_value ? parameter_value : default_value;
  }
  /// Access where it is stated, else that of the standard's default: rw.
  [[nodiscard]] canopen::Access access_or_default() const { return access.value_or(canopen::Access::ReadWrite); }
};

/// One object. Points into the document.
struct SheetObject {
  unsigned module = 0;  ///< type of module that brings it; 0 for the device itself
  std::uint16_t index = 0;
  const Section* section = nullptr;  ///< null where only sub-indices are described
  std::string name{};
  Stated<std::uint64_t> object_type{};
  Stated<std::uint64_t> sub_number{};
  Stated<std::uint64_t> compact_count{};  ///< CompactSubObj
  bool has_subs = false;                  ///< its entries are sub-indices, not the object itself
  std::vector<SheetEntry> entries{};      ///< ascending by sub-index

  /// Object code; VAR where none is stated.
  [[nodiscard]] ObjectCode code() const noexcept {
    return static_cast<ObjectCode>(object_type.value.value_or(static_cast<std::uint64_t>(ObjectCode::Variable)));
  }
  /// The entry @p sub_index, or null.
  [[nodiscard]] const SheetEntry* find(std::uint8_t sub_index) const noexcept;
  /// Where the object stands.
  [[nodiscard]] Place place() const noexcept;
};

/// Objects by index.
using SheetObjects = std::map<std::uint16_t, SheetObject>;

/// The entry @p index, @p sub_index of @p objects, or null.
[[nodiscard]] const SheetEntry* find_entry(const SheetObjects& objects, std::uint16_t index,
                                           std::uint8_t sub_index) noexcept;

}  // namespace eds
