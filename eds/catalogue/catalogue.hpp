#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "eds/catalogue/axis_rule.hpp"
#include "eds/catalogue/number.hpp"
#include "eds/sheet/names.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {

/// Axes that a unit has at most.
inline constexpr unsigned kMostAxes = 8;

/// Data types that CiA 306 asks of in DummyUsage.
inline constexpr std::uint16_t kFirstDummy = 0x0001;
inline constexpr std::uint16_t kLastDummy = 0x0007;

/// What every EDS says of its making and of the product, except what object 1018h says, and the words of the
/// reference page.
struct Header {
  std::string device;              ///< what the page calls the device: "the unit"
  std::string page_title;          ///< of the reference page
  std::int64_t file_version = 0;   ///< 0..255
  std::int64_t file_revision = 0;  ///< 0..255
  std::string created_time;        ///< hh:mm and AM or PM
  std::string created_date;        ///< mm-dd-yyyy
  std::string created_by;
  std::string vendor_name;
  std::string product_name;
  std::string order_code;
  bool lss_supported = false;
  std::vector<std::uint16_t> dummies;  ///< data types (kFirstDummy..kLastDummy) that RPDOs may map as dummies
  std::vector<std::string> comments;
};

/// One of the EDS files.
struct EdsFile {
  std::string name;
  FileContent content = FileContent::Axes;
  unsigned axes = 0;  ///< 1..kMostAxes where the content is Axes, else 0
  std::string description;
};

/// One entry of an object: what an index and a sub-index address.
struct Entry {
  std::uint8_t sub_index = 0;
  canopen::DataType type = canopen::DataType::Unsigned8;
  canopen::Access access = canopen::Access::ReadOnly;
  bool pdo_mappable = false;
  canopen::LimitCheck limit_check = canopen::LimitCheck::Table;
  bool default_stated = false;       ///< the EDS states the initial value as DefaultValue
  Number initial;                    ///< value after power-on; for strings only `text` counts; none for parameters
  std::optional<Number> other_axes;  ///< `initial` on axes 2 to 8, where it is not that of axis 1
  std::optional<Number> vector;      ///< `initial` on a vector axis, where it is not that of a servo axis
  std::optional<Number> several_axes;  ///< `initial` where there are several axes, where it is not that of one
  std::string start;  ///< what the device starts with where that is no constant: "measured"; else empty
  std::optional<Number> low;
  std::optional<Number> high;
  std::optional<std::uint32_t> object_flags;  ///< CiA 306, ObjFlags
  std::string unit;                           ///< physical unit; empty for plain numbers
  std::string name;
};

/// One object: a variable with one entry of sub-index 0, or an array or record with all its entries.
struct Object {
  std::uint16_t index = 0;
  ObjectCode code = ObjectCode::Variable;
  Scope scope = Scope::Unit;
  std::string name;
  std::string does;            ///< what it does in the simulation; empty for parameters
  std::vector<Entry> entries;  ///< ascending by sub-index
};

/// The object catalogue: everything the dictionary, the EDS and the reference page are made from.
struct Catalogue {
  Header header;
  std::vector<EdsFile> files;
  std::vector<AxisOffset> axis_offsets;
  std::vector<Object> objects;  ///< of the unit's dictionary, ascending by index
  std::vector<Object>
      parameters;  ///< of the drive objects, ascending by index, then in the order of the catalogue
};

/// The catalogue breaks a rule; the message names the row, the field and what was expected.
struct CatalogueError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads and checks a catalogue (JSON); throws CatalogueError.
[[nodiscard]] Catalogue parse_catalogue(std::string_view json);

/// Adds the rows of @p json, a list of parameter rows each of one kind of drive object, as far as the catalogue
/// does not list the parameter for it; throws CatalogueError.
void add_parameters(Catalogue& catalogue, std::string_view json);

/// The entry at @p index and @p sub_index, or null.
[[nodiscard]] const Entry* find_entry(std::span<const Object> objects, std::uint16_t index,
                                      std::uint8_t sub_index) noexcept;

}  // namespace eds
