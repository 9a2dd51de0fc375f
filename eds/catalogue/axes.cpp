#include "eds/catalogue/axes.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

namespace eds {
namespace {

/// Which drive objects list the parameters of a scope.
struct Listing {
  Scope scope;
  FileContent drive_object;
};
constexpr std::array kListings{
    Listing{Scope::Parameter, FileContent::ControlUnit},
    Listing{Scope::Parameter, FileContent::Servo},
    Listing{Scope::Parameter, FileContent::Vector},
    Listing{Scope::ControlUnitParameter, FileContent::ControlUnit},
    Listing{Scope::AxisParameter, FileContent::Servo},
    Listing{Scope::AxisParameter, FileContent::Vector},
    Listing{Scope::ServoParameter, FileContent::Servo},
    Listing{Scope::VectorParameter, FileContent::Vector},
};

bool lists(FileContent drive_object, Scope scope) {
  return std::ranges::any_of(
      kListings, [=](const Listing& row) { return row.scope == scope && row.drive_object == drive_object; });
}

void fit(Entry& entry, unsigned axis, DriveType type) {
  if (axis > 1 && entry.other_axes) entry.initial = *entry.other_axes;
  if (type == DriveType::Vector && entry.vector) entry.initial = *entry.vector;
}

/// An object that the unit has once, as it is with so many axes.
Object unit_object(const Object& object, std::span<const DriveType> axes) {
  if (object.index == kModuleList) return module_list(object, axes);
  Object result = object;
  for (Entry& entry : result.entries)
    if (axes.size() > 1 && entry.several_axes) entry.initial = *entry.several_axes;
  return result;
}

}  // namespace

std::vector<Object> axis_objects(const Catalogue& catalogue, unsigned axis, DriveType type) {
  std::vector<Object> objects;
  std::ranges::copy_if(catalogue.objects, std::back_inserter(objects),
                       [](const Object& object) { return object.scope == Scope::Axis; });
  for (Object& object : objects) {
    for (Entry& entry : object.entries) {
      const std::int64_t value =
          initial_on_axis(catalogue.axis_offsets, object.index, entry.sub_index, entry.initial.value, axis);
      if (value != entry.initial.value) entry.initial = {.value = value, .text = fmt::format("0x{:08X}", value)};
      fit(entry, axis, type);
    }
    object.index =
        static_cast<std::uint16_t>(object.index + axis_offset(catalogue.axis_offsets, object.index, axis));
  }
  return objects;
}

Object module_list(const Object& object, std::span<const DriveType> axes) {
  Object list = object;
  std::erase_if(list.entries, [&](const Entry& entry) { return entry.sub_index > axes.size(); });
  const auto count = static_cast<std::int64_t>(axes.size());
  list.entries.front().initial = {.value = count, .text = fmt::format("{}", count)};
  for (Entry& entry : list.entries)
    if (entry.sub_index != 0) fit(entry, entry.sub_index, axes[entry.sub_index - 1U]);
  return list;
}

std::vector<Object> unit_objects(const Catalogue& catalogue, std::span<const DriveType> axes) {
  std::vector<Object> objects;
  for (const Object& object : catalogue.objects)
    if (object.scope == Scope::Unit) objects.push_back(unit_object(object, axes));
  for (unsigned axis = 1; axis <= axes.size(); ++axis)
    std::ranges::move(axis_objects(catalogue, axis, axes[axis - 1]), std::back_inserter(objects));
  std::ranges::sort(objects, {}, &Object::index);
  return objects;
}

std::vector<Object> parameter_objects(const Catalogue& catalogue, FileContent drive_object) {
  std::vector<Object> objects;
  std::ranges::copy_if(catalogue.parameters, std::back_inserter(objects),
                       [=](const Object& object) { return lists(drive_object, object.scope); });
  return objects;
}

bool lists_parameter(const Catalogue& catalogue, Scope scope, std::uint16_t index) {
  return std::ranges::any_of(kListings, [&](const Listing& row) {
    if (row.scope != scope) return false;
    const std::vector<Object> listed = parameter_objects(catalogue, row.drive_object);
    return std::ranges::find(listed, index, &Object::index) != listed.end();
  });
}

}  // namespace eds
