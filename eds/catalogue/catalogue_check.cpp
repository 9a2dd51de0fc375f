#include "eds/catalogue/catalogue_check.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/catalogue/axes.hpp"

namespace eds {
namespace {

struct Address {
  std::uint16_t index;
  std::uint8_t sub_index;
};

/// CiA 301, 7.4: every device has its type, the error register and its identity down to the revision the EDS
/// repeats.
constexpr std::array kMandatory{Address{0x1000, 0}, Address{0x1001, 0}, Address{0x1018, 1}, Address{0x1018, 2},
                                Address{0x1018, 3}};

[[noreturn]] void fail(std::uint16_t index, unsigned sub, std::string_view expected) {
  throw CatalogueError{fmt::format("{:04X}:{:02X}: expected {}", index, sub, expected)};
}

/// CiA 301, 7.4.3: sub-index 0 of an array or record tells the highest sub-index.
void check_highest_sub(const Object& object) {
  const Entry& first = object.entries.front();
  const std::int64_t highest = object.entries.back().sub_index;
  const bool fixed = first.access == canopen::Access::ReadOnly || first.access == canopen::Access::Constant;
  if (fixed && first.initial.value != highest)
    fail(object.index, 0, fmt::format("the highest sub-index {} as default, got {}", highest, first.initial.text));
  if (first.initial.value > highest)
    fail(object.index, 0,
         fmt::format("at most the highest sub-index {} as default, got {}", highest, first.initial.text));
}

void check_array(const Object& object) {
  for (std::size_t n = 1; n < object.entries.size(); ++n) {
    if (object.entries[n].sub_index != n)
      fail(object.index, static_cast<unsigned>(n), "a row, the array has a gap");
    if (object.entries[n].type != object.entries[1].type)
      fail(object.index, static_cast<unsigned>(n), "the type of sub-index 1, an array has one type");
  }
}

void check_structure(const Object& object) {
  const auto by_sub = [](const Entry& a, const Entry& b) { return a.sub_index < b.sub_index; };
  if (!std::ranges::is_sorted(object.entries, by_sub)) fail(object.index, 0, "rows in ascending order of \"sub\"");
  const bool has_first = !object.entries.empty() && object.entries.front().sub_index == 0;
  if (object.code == ObjectCode::Variable) {
    if (!has_first || object.entries.size() != 1)
      fail(object.index, 0, "one row with sub 00 for a VAR, or an ARRAY or RECORD row first");
    return;
  }
  if (!has_first || object.entries.size() < 2) fail(object.index, 0, "rows for sub 00 and at least one more");
  if (object.entries.front().type != canopen::DataType::Unsigned8) fail(object.index, 0, "type UNSIGNED8");
  check_highest_sub(object);
  if (object.code == ObjectCode::Array) check_array(object);
}

bool may_carry(bool receive, canopen::Access access) noexcept {
  using canopen::Access;
  if (receive)
    return access == Access::ReadWriteWrite || access == Access::WriteOnly || access == Access::ReadWrite;
  return access != Access::ReadWriteWrite && access != Access::WriteOnly;
}

/// Bits of the mapped entry; the mapping parameter holds index, sub-index and length (CiA 301, 7.5.2.36).
std::int64_t check_mapped(const Catalogue& catalogue, const Object& object, const Entry& mapping) {
  const std::int64_t value = mapping.initial.value;
  const auto index = static_cast<std::uint16_t>(value >> 16 & 0xFFFF);
  const auto sub = static_cast<std::uint8_t>(value >> 8 & 0xFF);
  const std::int64_t bits = value & 0xFF;
  const Entry* const target = find_entry(catalogue.objects, index, sub);
  if (target == nullptr || !target->pdo_mappable)
    fail(object.index, mapping.sub_index, "a mappable entry as default");
  if (bits != std::int64_t{8} * canopen::size_of(target->type))
    fail(object.index, mapping.sub_index, "the length of the mapped entry, in bits");
  if (!may_carry(object.index < 0x1800, target->access))
    fail(object.index, mapping.sub_index, "an entry that may be mapped in this direction");
  return bits;
}

void check_mapping_object(const Catalogue& catalogue, const Object& object) {
  if (!is_mapping_parameter(object.index)) return;
  const auto count = static_cast<std::size_t>(object.entries.front().initial.value);
  std::int64_t bits = 0;
  for (std::size_t n = 1; n < object.entries.size() && n <= count; ++n)
    bits += check_mapped(catalogue, object, object.entries[n]);
  if (bits > 64) fail(object.index, 0, fmt::format("at most 64 mapped bits, got {}", bits));
}

constexpr std::uint16_t kFirstParameter = 0x2000;
constexpr std::uint16_t kLastParameter = 0x470F;

/// The sub-index of a parameter object is the parameter index, from 0, so that sub-index 0 counts nothing.
void check_parameter(const Object& object) {
  if (object.index < kFirstParameter || object.index > kLastParameter)
    fail(object.index, 0, "a parameter object, 2000h to 470Fh");
  if (object.code == ObjectCode::Record) fail(object.index, 0, "VAR or ARRAY for a parameter");
  if (object.entries.empty()) fail(object.index, 0, "a row, the parameter has no value");
  if (object.code == ObjectCode::Variable && object.entries.size() != 1)
    fail(object.index, 1, "one row with sub 00 for a VAR, or an ARRAY row first");
  for (std::size_t n = 0; n < object.entries.size(); ++n) {
    if (object.entries[n].sub_index != n)
      fail(object.index, static_cast<unsigned>(n), "a row, the array has a gap");
    if (object.entries[n].type != object.entries[0].type)
      fail(object.index, static_cast<unsigned>(n), "the type of sub-index 0, a parameter has one type");
  }
}

void check_once(std::span<const Object> objects, std::string_view where) {
  const auto twice = std::ranges::adjacent_find(objects, {}, &Object::index);
  if (twice != objects.end()) fail(twice->index, 0, fmt::format("one object of this index in {}", where));
}

void check_parameters(const Catalogue& catalogue) {
  for (const Object& object : catalogue.parameters) check_parameter(object);
  for (const FileContent drive_object : {FileContent::ControlUnit, FileContent::Servo, FileContent::Vector})
    check_once(parameter_objects(catalogue, drive_object),
               fmt::format("the drive object {}", name_of(kFileContents, drive_object).text));
}

/// Every object of an axis has an offset, and none meets another one in a unit of the most axes.
void check_axes(const Catalogue& catalogue) {
  for (const Object& object : catalogue.objects) {
    const bool moves = std::ranges::any_of(catalogue.axis_offsets, [&](const AxisOffset& row) {
      return object.index >= row.first && object.index <= row.last;
    });
    if (object.scope == Scope::Axis && !moves) fail(object.index, 0, "an axis offset for an object of an axis");
    if (object.index == kModuleList && object.entries.size() != kMostAxes + 1)
      fail(object.index, 0, fmt::format("{} modules", kMostAxes));
  }
  const std::vector<DriveType> most(kMostAxes, DriveType::Servo);
  check_once(unit_objects(catalogue, most), fmt::format("a unit of {} axes", kMostAxes));
}

}  // namespace

void check_objects(const Catalogue& catalogue) {
  for (const Address& address : kMandatory)
    if (find_entry(catalogue.objects, address.index, address.sub_index) == nullptr)
      fail(address.index, address.sub_index, "a row for this mandatory entry");
  for (const Object& object : catalogue.objects) check_structure(object);
  for (const Object& object : catalogue.objects) check_mapping_object(catalogue, object);
  check_axes(catalogue);
  check_parameters(catalogue);
  for (const Object& object : catalogue.objects)
    if (object.does.empty()) fail(object.index, 0, "\"does\" in the row that opens the object");
}

}  // namespace eds
