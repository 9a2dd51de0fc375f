#include "trace/signal/signal.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "text/number.hpp"
#include "trace/signal/quantity_table.hpp"

namespace trace {
namespace {

using drive::DriveObject;
using drive::DriveUnit;
using Found = tl::expected<Signal, Problem>;

/// A parameter as a name writes it: "r0899.2", "p1001[2]".
struct ParameterName {
  std::uint16_t number = 0;
  std::optional<std::size_t> index{};
  std::optional<unsigned> bit{};
};

Found problem(Problem::Kind kind, std::string expected) {
  return tl::unexpected{Problem{kind, {}, std::move(expected)}};
}

std::optional<ParameterName> parse_parameter(std::string_view text) noexcept {
  if (text.empty() || (text.front() != 'r' && text.front() != 'p')) return std::nullopt;
  text.remove_prefix(1);
  ParameterName name;
  const auto number = text::take_integer<std::uint16_t>(text);
  if (!number) return std::nullopt;
  name.number = *number;
  if (text.starts_with('[')) {
    text.remove_prefix(1);
    name.index = text::take_integer<std::size_t>(text);
    if (!name.index || !text.starts_with(']')) return std::nullopt;
    text.remove_prefix(1);
  }
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    name.bit = text::take_integer<unsigned>(text);
    if (!name.bit) return std::nullopt;
  }
  return text.empty() ? std::optional{name} : std::nullopt;
}

/// How many bits of @p row can be signals.
unsigned bits_of(const drive::ParameterRow& row) noexcept {
  const bool has_bits = row.type != drive::DataType::F32 && !is_bico_input(row.type);
  return has_bits ? 8U * row_of(row.type).size : 0U;
}

Found parameter_signal(const DriveUnit& unit, const DriveObject& object, const ParameterName& name) {
  const Place place = place_of(unit, object);
  const auto placed = object.parameter(name.number);
  if (!placed)
    return problem(Problem::Kind::NotFound,
                   fmt::format("a signal of the unit: {} has no parameter {:04}", place_name(place), name.number));
  const drive::ParameterRow& row = *(*placed)->row;
  // The bit of a binector that stands at an index of its own is that index.
  const bool is_index = row.output == drive::Output::Bits && name.bit && !name.index;
  const std::size_t index = is_index ? *name.bit : name.index.value_or(0);
  const std::string text = parameter_text(row);
  if (index >= row.count)
    return problem(Problem::Kind::NotFound, row.count == 1
                                                ? fmt::format("{} without an index: it has none", text)
                                                : fmt::format("{} with an index 0 to {}", text, row.count - 1));
  const std::optional<unsigned> bit = is_index ? std::nullopt : name.bit;
  if (bit && *bit >= bits_of(row))
    return problem(Problem::Kind::NotFound, bits_of(row) == 0
                                                ? fmt::format("{} without a bit: it is no word", text)
                                                : fmt::format("{} with a bit 0 to {}", text, bits_of(row) - 1));
  std::string full = fmt::format("{}/{}", place_text(place), text);
  if (row.count > 1) full += fmt::format("[{}]", index);
  const Reader reader = Reader::of_parameter(object, **placed, index);
  if (!bit) return Signal{std::move(full), row_of(row.unit).text, row.name, reader};
  return Signal{fmt::format("{}.{}", full, *bit), {}, row.name, reader.bit(*bit)};
}

template <class Owner>
std::optional<Signal> quantity_signal(std::span<const QuantityRow<Owner>> rows, const Owner& owner, Place place,
                                      std::string_view name) {
  const auto row = std::ranges::find(rows, name, &QuantityRow<Owner>::name);
  if (row == rows.end()) return std::nullopt;
  const drive::UnitRow& unit = row_of(row->unit);
  return Signal{fmt::format("{}/{}", place_text(place), name), unit.text, row->text,
                Reader::of_quantity(owner, row->get, unit.si)};
}

Found signal_at(const DriveUnit& unit, Place place, std::string_view name) {
  const DriveObject* const object = object_at(unit, place);
  if (object == nullptr)
    return problem(Problem::Kind::NotFound,
                   fmt::format("a place of the unit, 0 to {}: it has no {}", unit.axes().size(),
                               place == kInfeedPlace ? "infeed" : fmt::format("axis {}", place)));
  if (const auto parameter = parse_parameter(name)) return parameter_signal(unit, *object, *parameter);
  auto found = place == kControlUnitPlace ? quantity_signal(unit_quantities(), unit, place, name)
               : place != kInfeedPlace ? quantity_signal(axis_quantities(), unit.axes()[place - 1U], place, name)
                                       : std::nullopt;
  if (found) return std::move(*found);
  return problem(
      Problem::Kind::NotFound,
      fmt::format("a signal of the unit such as 1/speed or 1/r0063: {} has no {}", place_name(place), name));
}

/// The only signal that is called @p name wherever it is.
Found signal_anywhere(const DriveUnit& unit, std::string_view name) {
  std::optional<Signal> only;
  bool ambiguous = false;
  std::optional<Problem> reason;
  unit.for_each_object([&](const DriveObject& object) {
    Found found = signal_at(unit, place_of(unit, object), name);
    if (!found) {
      // That something is wrong with index or bit says more than that there is nothing.
      const bool says_more = parse_parameter(name) && object.parameter(parse_parameter(name)->number).has_value();
      if (!reason || says_more) reason = found.error();
      return;
    }
    ambiguous = ambiguous || only.has_value();
    if (!only) only = std::move(*found);
  });
  if (ambiguous)
    return problem(Problem::Kind::NotFound,
                   fmt::format("a place before {}, such as {}: several drive objects have it", name, only->name));
  if (only) return std::move(*only);
  return tl::unexpected{*reason};
}

}  // namespace

Found find_signal(const DriveUnit& unit, std::string_view name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos) return signal_anywhere(unit, name);
  const auto place = parse_place(name.substr(0, slash));
  if (!place)
    return problem(
        Problem::Kind::Malformed,
        fmt::format("a place before the slash: 0 (control unit), 1 to {} (axis) or infeed", unit.axes().size()));
  return signal_at(unit, *place, name.substr(slash + 1));
}

}  // namespace trace
