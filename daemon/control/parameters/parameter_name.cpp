#include "daemon/control/parameters/parameter_name.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "daemon/control/place.hpp"
#include "text/number.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

/// What a text says, before anybody is asked.
struct Name {
  std::string place;  ///< empty: not said
  std::uint16_t number;
  std::optional<std::size_t> index;
  std::optional<unsigned> bit;
};

tl::unexpected<control::Error> refused(ErrorCode code, std::string message, json details = {}) {
  return tl::unexpected{control::Error{code, std::move(message), std::move(details)}};
}

bool take(std::string_view& text, char mark) noexcept {
  if (text.empty() || text.front() != mark) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<Name> name_of(std::string_view text) {
  constexpr std::size_t kLongest = 32;
  if (text.size() > kLongest) return std::nullopt;
  Name name{};
  if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
    name.place = text.substr(0, slash);
    text.remove_prefix(slash + 1);
    if (name.place.empty()) return std::nullopt;
  }
  if (!text.empty() && std::string_view{"pPrR"}.find(text.front()) != std::string_view::npos)
    text.remove_prefix(1);
  const auto number = text::take_integer<std::uint16_t>(text);
  if (!number) return std::nullopt;
  name.number = *number;
  if (take(text, '[')) {
    name.index = text::take_integer<std::uint16_t>(text);
    if (!name.index || !take(text, ']')) return std::nullopt;
  }
  if (take(text, '.')) {
    name.bit = text::take_integer<std::uint16_t>(text);
    if (!name.bit) return std::nullopt;
  }
  return text.empty() ? std::optional{name} : std::nullopt;
}

/// The drive objects of @p unit that have parameter @p number.
std::vector<drive::DriveObject*> owners_of(drive::DriveUnit& unit, std::uint16_t number) {
  std::vector<drive::DriveObject*> owners;
  unit.for_each_object([&](drive::DriveObject& object) {
    if (object.parameter(number)) owners.push_back(&object);
  });
  return owners;
}

Taken<drive::DriveObject*> only_owner(drive::DriveUnit& unit, const Name& name, std::string_view text) {
  const auto owners = owners_of(unit, name.number);
  if (owners.size() == 1) return owners.front();
  if (owners.empty())
    return refused(ErrorCode::NotFound, fmt::format("{}: no drive object of the unit has this parameter", text));
  json places = json::array();
  std::string names;
  for (const drive::DriveObject* const owner : owners) {
    places.push_back(place_of(*owner));
    names.append(names.empty() ? "" : ", ").append(place_text(*owner));
  }
  const json first = places.front();
  return refused(ErrorCode::BadParameter,
                 fmt::format("{}: {} have it: say which by axis, or as in {}/{}", text, names,
                             first.is_string() ? first.get<std::string>() : first.dump(), text),
                 {{"axes", std::move(places)}});
}

Taken<drive::DriveObject*> owner_of(drive::DriveUnit& unit, drive::DriveObject* object, const Name& name,
                                    std::string_view text) {
  if (!name.place.empty()) return find_place(unit, name.place);
  return object != nullptr ? Taken<drive::DriveObject*>{object} : only_owner(unit, name, text);
}

/// The bits of a value are those of its type; where a bit has an index of its own it is that index.
Taken<ParameterTarget> with_bit(ParameterTarget target, const Name& name, std::string_view text) {
  if (!name.bit) return target;
  const drive::DataTypeRow& type = drive::row_of(target.row().type);
  const unsigned bits = target.row().type == drive::DataType::F32 ? 0 : 8U * type.size;
  if (*name.bit >= bits || drive::is_bico_input(target.row().type))
    return refused(ErrorCode::NotFound, bits == 0 || drive::is_bico_input(target.row().type)
                                            ? fmt::format("{}: it has no bits", text)
                                            : fmt::format("{}: it has the bits 0 to {}", text, bits - 1));
  target.bit = name.bit;
  return target;
}

}  // namespace

Taken<ParameterTarget> find_parameter_target(drive::DriveUnit& unit, drive::DriveObject* object,
                                             std::string_view text) {
  auto name = name_of(text);
  if (!name) {
    const json got = text;
    return tl::unexpected{unexpected_value("parameter", "one as p1120, r0722.3, p1070[1] or 2/p1120", &got)};
  }
  const auto owner = owner_of(unit, object, *name, text);
  if (!owner) return tl::unexpected{owner.error()};
  const auto placed = (*owner)->parameter(name->number);
  if (!placed)
    return refused(ErrorCode::NotFound, fmt::format("{}: {} has no such parameter", text, place_text(**owner)));
  const drive::ParameterRow& row = *(*placed)->row;
  if (row.output == drive::Output::Bits && name->bit && !name->index)
    name->index = *std::exchange(name->bit, std::nullopt);
  const std::size_t index = name->index.value_or(0);
  if (index >= row.count)
    return refused(ErrorCode::NotFound, row.count == 1
                                            ? fmt::format("{}: it has no indices", text)
                                            : fmt::format("{}: it has the indices 0 to {}", text, row.count - 1));
  return with_bit({*owner, *placed, index, {}}, *name, text);
}

std::string parameter_text(const drive::ParameterRow& row, std::size_t index) {
  const std::string name = drive::parameter_text(row);
  return row.count == 1 ? name : fmt::format("{}[{}]", name, index);
}

std::string parameter_text(const ParameterTarget& target) {
  const std::string name = parameter_text(target.row(), target.index);
  return target.bit ? fmt::format("{}.{}", name, *target.bit) : name;
}

}  // namespace axisd
