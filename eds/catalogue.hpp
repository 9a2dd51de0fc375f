#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "eds/names.hpp"
#include "eds/number.hpp"

namespace eds {

/// What the EDS says of the file and of the product, except what object 1018h says.
struct Header {
  std::string file_name;
  std::int64_t file_version = 0;   ///< 0..255
  std::int64_t file_revision = 0;  ///< 0..255
  std::string description;
  std::string created_time;  ///< hh:mm and AM or PM
  std::string created_date;  ///< mm-dd-yyyy
  std::string created_by;
  std::string vendor_name;
  std::string product_name;
  std::string order_code;
  std::vector<std::string> comments;
};

/// One entry of an object: what an index and a sub-index address.
struct Entry {
  std::uint8_t sub_index = 0;
  canopen::DataType type = canopen::DataType::Unsigned8;
  canopen::Access access = canopen::Access::ReadOnly;
  bool pdo_mappable = false;
  canopen::LimitCheck limit_check = canopen::LimitCheck::Table;
  bool default_stated = false;  ///< the EDS states the initial value as DefaultValue
  Number initial;               ///< value after power-on; for strings only `text` counts
  std::optional<Number> low;
  std::optional<Number> high;
  std::optional<std::uint32_t> object_flags;  ///< CiA 306, ObjFlags
  std::string name;
};

/// One object: a variable with one entry of sub-index 0, or an array or record with all its entries.
struct Object {
  std::uint16_t index = 0;
  ObjectCode code = ObjectCode::Variable;
  Scope scope = Scope::Unit;
  std::string name;
  std::vector<Entry> entries;  ///< ascending by sub-index
};

/// The object catalogue: everything the dictionary, the EDS and the reference page are made from.
struct Catalogue {
  Header header;
  std::vector<Object> objects;  ///< ascending by index
};

/// The catalogue breaks a rule; the message names the row, the field and what was expected.
struct CatalogueError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads and checks a catalogue (JSON); throws CatalogueError.
[[nodiscard]] Catalogue parse_catalogue(std::string_view json);

/// The entry at @p index and @p sub_index, or null.
[[nodiscard]] const Entry* find_entry(const Catalogue& catalogue, std::uint16_t index,
                                      std::uint8_t sub_index) noexcept;

}  // namespace eds
