// Parameters by name: read, write.
#include <array>

#include <fmt/format.h>

#include "daemon/control/handlers.hpp"
#include "daemon/control/parameters/parameter_value.hpp"
#include "daemon/control/parameters/parameter_view.hpp"
#include "daemon/control/parameters/parameter_write.hpp"
#include "daemon/control/place.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// So many fit into a line with all that is told of them.
constexpr std::size_t kMostAtOnce = 32;
constexpr std::string_view kNames = "parameters";

/// A list of texts, or a single one.
Taken<std::vector<std::string>> names_of(const json& params) {
  const json* const names = Arguments{params}.find(kNames);
  const auto refused = [&] {
    return tl::unexpected{
        unexpected_value(kNames, fmt::format("a list of 1 to {} parameters", kMostAtOnce), names)};
  };
  if (names == nullptr) return refused();
  if (names->is_string()) return std::vector{names->get<std::string>()};
  if (!names->is_array() || names->empty() || names->size() > kMostAtOnce) return refused();
  std::vector<std::string> texts;
  for (const json& name : *names) {
    if (!name.is_string()) return refused();
    texts.push_back(name.get<std::string>());
  }
  return texts;
}

json entry_of(const ParameterView& view, const ParameterTarget& target) {
  json entry = view.entry(*target.object, *target.placed, target.index);
  if (!target.bit) return entry;
  entry["parameter"] = parameter_text(target);
  entry["bit"] = *target.bit;
  entry["value"] = static_cast<std::uint64_t>(entry.at("value").get<std::int64_t>()) >> *target.bit & 1U;
  return entry;
}

Outcome read_parameters(const Call& call, const json& params) {
  const auto names = names_of(params);
  if (!names) return tl::unexpected{names.error()};
  const auto object = optional_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  call.instance.device().tell_time(call.now);
  const ParameterView view{call.instance};
  json entries = json::array();
  for (const std::string& name : *names) {
    const auto target = find_parameter_target(unit_of(call), *object, name);
    if (!target) return tl::unexpected{target.error()};
    entries.push_back(entry_of(view, *target));
  }
  return json{{"parameters", std::move(entries)}};
}

/// What is told of a value that was written.
json written_json(const drive::DriveUnit& unit, const ParameterTarget& target) {
  json told{{"axis", place_of(*target.object)},
            {"drive_object", target.object->number()},
            {"parameter", parameter_text(target)},
            {"unit", drive::row_of(target.row().unit).text}};
  const auto value = unit.read(target.object->number(), target.row().number, target.index);
  if (!value) return told;
  told["value"] =
      target.bit ? json(value->bits >> *target.bit & 1U) : value_json(target.row(), *value, *target.object);
  return told;
}

Outcome write_parameter(const Call& call, const json& params) {
  const Arguments arguments{params};
  const auto name = arguments.text("parameter");
  if (!name) return tl::unexpected{name.error()};
  const json* const value = arguments.find("value");
  if (value == nullptr) return tl::unexpected{unexpected_value("value", "a number or a text", nullptr)};
  const auto object = optional_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  const auto target = find_parameter_target(unit_of(call), *object, *name);
  if (!target) return tl::unexpected{target.error()};
  const auto number = number_of(unit_of(call), *target, *value);
  if (!number) return tl::unexpected{number.error()};
  const auto written = write_and_tell(call, *target, *number);
  if (!written) return tl::unexpected{written.error()};
  return written_json(unit_of(call), *target);
}

constexpr std::array kParameterHandlers{
    Handler{"parameter.read", &read_parameters},
    Handler{"parameter.write", &write_parameter},
};

}  // namespace

std::span<const Handler> parameter_handlers() noexcept {
  return kParameterHandlers;
}

}  // namespace axisd
