#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace drive {
class DriveObject;
}

/// What a master looks up that knows PROFIdrive but not the drive.
namespace drive::profile_value {

/// r0107.
double object_type(const DriveObject& object, std::size_t index) noexcept;
/// r0964.
double device_identification(const DriveObject& object, std::size_t index) noexcept;
/// r0965.
double profile_number(const DriveObject& object, std::size_t index) noexcept;

/// A list of parameters, ascending. Its last index is the number of the list that goes on, 0 where none does.
struct ListRow {
  std::uint16_t number;
  std::uint16_t count;
};
inline constexpr std::array kExisting{ListRow{980, 300}, ListRow{981, 300}, ListRow{982, 300}};
inline constexpr std::array kModified{ListRow{990, 300}, ListRow{991, 100}};
/// How many parameters @p lists have room for.
constexpr std::size_t room_of(std::span<const ListRow> lists) noexcept {
  std::size_t room = 0;
  for (const ListRow& list : lists) room += list.count - std::size_t{1};
  return room;
}

/// Index @p index of list @p List of kExisting: the parameters that the drive object has.
double existing_parameter(std::size_t list, const DriveObject& object, std::size_t index) noexcept;
template <std::size_t List>
double existing(const DriveObject& object, std::size_t index) noexcept {
  return existing_parameter(List, object, index);
}
/// The same of kModified: those that are saved and have another value than in a new unit.
double modified_parameter(std::size_t list, const DriveObject& object, std::size_t index) noexcept;
template <std::size_t List>
double modified(const DriveObject& object, std::size_t index) noexcept {
  return modified_parameter(List, object, index);
}

}  // namespace drive::profile_value
