#include "drive/values/profile_values.hpp"

#include <algorithm>
#include <span>

#include "drive/object/drive_object.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/unit_values.hpp"

namespace drive::profile_value {
namespace {

bool exists(const DriveObject& object, const PlacedRow& placed) noexcept {
  return object.provides(*placed.row);
}

bool is_modified(const DriveObject& object, const PlacedRow& placed) noexcept {
  return is_saved(*placed.row) && exists(object, placed) && !object.is_as_delivered(placed);
}

/// Number @p place, from 0, of the parameters of @p object that belong to a list; 0 behind the last one.
std::uint16_t number_at(std::size_t place, const DriveObject& object, ListPlace::Belongs belongs) noexcept {
  ListPlace& last = object.list_place();
  const bool goes_on =
      last.belongs == belongs && last.changes == object.parameter_changes() && last.count <= place;
  if (!goes_on) last = {.belongs = belongs, .changes = object.parameter_changes()};
  const std::span<const PlacedRow> rows = parameters_of(object.kind());
  for (; last.row < rows.size(); ++last.row) {
    if (!belongs(object, rows[last.row])) continue;
    if (last.count == place) return rows[last.row].row->number;
    ++last.count;
  }
  return 0;
}

double number_in(std::span<const ListRow> lists, std::size_t list, std::size_t index, const DriveObject& object,
                 ListPlace::Belongs belongs) noexcept {
  const std::uint16_t number = number_at(room_of(lists.first(list)) + index, object, belongs);
  if (index + 1 < lists[list].count) return number;
  return number != 0 && list + 1 < lists.size() ? lists[list + 1].number : 0.0;
}

}  // namespace

double object_type(const DriveObject& object, std::size_t) noexcept {
  if (object.kind() != ObjectKind::Infeed) return axis_type(object.kind());
  return factory::object_type(object.context(), kInfeedNumber - kControlUnitNumber);
}

double device_identification(const DriveObject& object, std::size_t index) noexcept {
  constexpr double kManufacturer = 42.0, kControlUnit320 = 5210.0;
  constexpr double kYear = 2016.0, kDayAndMonth = 3006.0;
  const std::array values{kManufacturer,
                          kControlUnit320,
                          static_cast<double>(kFirmware / kFirmwarePatches),
                          kYear,
                          kDayAndMonth,
                          static_cast<double>(object.objects_of_unit()),
                          static_cast<double>(kFirmware % kFirmwarePatches)};
  return values[index];
}

double profile_number(const DriveObject&, std::size_t) noexcept {
  constexpr unsigned kProfile = 3, kVersion = 41;
  return kProfile << 8 | kVersion;
}

double existing_parameter(std::size_t list, const DriveObject& object, std::size_t index) noexcept {
  return number_in(kExisting, list, index, object, exists);
}

double modified_parameter(std::size_t list, const DriveObject& object, std::size_t index) noexcept {
  return number_in(kModified, list, index, object, is_modified);
}

}  // namespace drive::profile_value
