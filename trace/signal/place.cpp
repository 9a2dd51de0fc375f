#include "trace/signal/place.hpp"

#include <fmt/format.h>

#include "text/number.hpp"

namespace trace {
namespace {

constexpr std::string_view kInfeedText = "infeed";

}  // namespace

std::optional<Place> parse_place(std::string_view text) noexcept {
  if (text == kInfeedText) return kInfeedPlace;
  const auto number = text::integer<std::uint8_t>(text);
  return number && *number <= drive::kMostAxes ? std::optional<Place>{*number} : std::nullopt;
}

std::string place_text(Place place) {
  return place == kInfeedPlace ? std::string{kInfeedText} : fmt::format("{}", place);
}

const drive::DriveObject* object_at(const drive::DriveUnit& unit, Place place) noexcept {
  if (place == kControlUnitPlace) return &unit.control_unit();
  if (place == kInfeedPlace) return unit.infeed();
  return place <= unit.axes().size() ? &unit.axes()[place - 1U] : nullptr;
}

Place place_of(const drive::DriveUnit& unit, const drive::DriveObject& object) noexcept {
  if (object.kind() == drive::ObjectKind::ControlUnit) return kControlUnitPlace;
  if (object.kind() == drive::ObjectKind::Infeed) return kInfeedPlace;
  return static_cast<Place>(object.number() - unit.first_axis() + 1);
}

std::string place_name(Place place) {
  if (place == kControlUnitPlace) return "the control unit";
  return place == kInfeedPlace ? "the infeed" : fmt::format("axis {}", place);
}

}  // namespace trace
