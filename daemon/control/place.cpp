#include "daemon/control/place.hpp"

#include <fmt/format.h>

#include "text/number.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr std::string_view kInfeed = "infeed";
constexpr std::string_view kKey = "axis";

std::size_t axis_number(const drive::DriveObject& object) noexcept {
  return std::size_t{object.context().module} + 1;
}

std::string expected_places(const drive::DriveUnit& unit) {
  return fmt::format("0 for the control unit{} an axis 1 to {}",
                     unit.infeed() != nullptr ? ", \"infeed\" or" : " or", unit.axes().size());
}

drive::DriveObject* object_at(drive::DriveUnit& unit, std::int64_t number) noexcept {
  if (number == 0) return &unit.control_unit();
  const auto axes = static_cast<std::int64_t>(unit.axes().size());
  return number > 0 && number <= axes ? &unit.axes()[static_cast<std::size_t>(number - 1)] : nullptr;
}

drive::DriveObject* object_named(drive::DriveUnit& unit, const std::string& name) noexcept {
  if (name == kInfeed) return unit.infeed();
  const auto number = text::integer<std::int64_t>(name);
  return number ? object_at(unit, *number) : nullptr;
}

}  // namespace

json place_of(const drive::DriveObject& object) {
  if (object.kind() == drive::ObjectKind::ControlUnit) return 0;
  if (object.kind() == drive::ObjectKind::Infeed) return kInfeed;
  return axis_number(object);
}

std::string place_text(const drive::DriveObject& object) {
  if (object.kind() == drive::ObjectKind::ControlUnit) return "the control unit";
  if (object.kind() == drive::ObjectKind::Infeed) return "the infeed";
  return fmt::format("axis {}", axis_number(object));
}

Taken<drive::DriveObject*> find_place(drive::DriveUnit& unit, const json& place) {
  drive::DriveObject* found = nullptr;
  const bool is_small = place.is_number_integer() && place >= 0 && place <= drive::kMostAxes;
  if (is_small) found = object_at(unit, place.get<std::int64_t>());
  if (place.is_string()) found = object_named(unit, place.get_ref<const std::string&>());
  if (found != nullptr) return found;
  return tl::unexpected{unexpected_value(kKey, expected_places(unit), &place)};
}

Taken<drive::DriveObject*> required_place(drive::DriveUnit& unit, const json& params) {
  const json* const place = Arguments{params}.find(kKey);
  if (place != nullptr) return find_place(unit, *place);
  return tl::unexpected{unexpected_value(kKey, expected_places(unit), nullptr)};
}

Taken<drive::DriveObject*> optional_place(drive::DriveUnit& unit, const json& params) {
  const json* const place = Arguments{params}.find(kKey);
  return place != nullptr ? find_place(unit, *place) : Taken<drive::DriveObject*>{nullptr};
}

Taken<std::size_t> required_axis(const Instance& instance, const json& params) {
  const auto axes = static_cast<std::int64_t>(instance.device().unit().axes().size());
  return Arguments{params}.integer(kKey, 1, axes).map([](std::int64_t axis) {
    return static_cast<std::size_t>(axis);
  });
}

}  // namespace axisd
