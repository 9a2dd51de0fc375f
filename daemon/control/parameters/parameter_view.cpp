#include "daemon/control/parameters/parameter_view.hpp"

#include <algorithm>

#include "daemon/control/parameters/parameter_value.hpp"
#include "daemon/control/place.hpp"
#include "drive/catalogue/effect_text.hpp"
#include "drive/parameter/bico_text.hpp"
#include "drive/parameter/transfer.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Of the inputs that a parameter is connected to so many are named.
constexpr std::size_t kMostUses = 12;

const std::vector<ParameterValue>* presets_of(const Configuration& configuration,
                                              const drive::DriveObject& object) noexcept {
  if (object.kind() == drive::ObjectKind::ControlUnit) return &configuration.parameters;
  if (object.kind() == drive::ObjectKind::Infeed)
    return configuration.infeed ? &configuration.infeed->parameters : nullptr;
  return &configuration.axes[object.context().module].parameters;
}

json identity(const drive::DriveObject& object, const drive::ParameterRow& row, std::size_t index) {
  return {{"axis", place_of(object)},
          {"drive_object", object.number()},
          {"parameter", parameter_text(row, index)},
          {"number", row.number},
          {"index", index},
          {"name", row.name},
          {"unit", drive::row_of(row.unit).text}};
}

}  // namespace

ParameterView::ParameterView(const Instance& instance)
    : instance_{instance},
      unit_{instance.device().unit()},
      saved_{instance.device().saved_parameters()},
      interconnections_{unit_} {}

json ParameterView::definition(const drive::ParameterRow& row) {
  json definition{{"number", row.number},
                  {"indices", static_cast<int>(row.count)},
                  {"name", row.name},
                  {"unit", drive::row_of(row.unit).text},
                  {"type", drive::row_of(row.type).text},
                  {"access", row.is_writable() ? "read-write" : "read-only"},
                  {"effect", drive::effect_text(row)}};
  if (row.is_writable()) definition["when"] = drive::row_of(row.when).text;
  if (const json limits = limits_json(row); row.is_writable() && !limits.is_null()) {
    definition["minimum"] = limits.at("minimum");
    definition["maximum"] = limits.at("maximum");
  }
  return definition;
}

drive::ParameterValue ParameterView::present(const drive::DriveObject& object, const drive::PlacedRow& placed,
                                             std::size_t index) const noexcept {
  return drive::transferred(placed.row->type, object.value(placed, index));
}

drive::ParameterValue ParameterView::reference_value(const drive::DriveObject& object,
                                                     const drive::ParameterRow& row, std::size_t index,
                                                     Reference reference) const noexcept {
  if (reference == Reference::Stored)
    if (const auto stored = saved_.find(object.number(), row.number, index)) return *stored;
  return drive::transferred(row.type, drive::factory_value(row, object.context(), index));
}

bool ParameterView::differs(const drive::DriveObject& object, const drive::PlacedRow& placed, std::size_t index,
                            Reference reference) const noexcept {
  const drive::ParameterRow& row = *placed.row;
  return drive::is_saved(row) &&
         !drive::is_same(present(object, placed, index), reference_value(object, row, index, reference));
}

void ParameterView::add_access(json& entry, const drive::DriveObject& object,
                               const drive::ParameterRow& row) const {
  const auto refusal = object.state_refusal(row);
  entry["writable"] = !refusal && !instance_.device().is_saving();
  if (refusal && row.is_writable()) entry["refusal"] = drive::text_of(refusal->why);
}

void ParameterView::add_references(json& entry, const drive::DriveObject& object, const drive::PlacedRow& placed,
                                   std::size_t index) const {
  const drive::ParameterRow& row = *placed.row;
  if (!drive::is_saved(row)) return;
  const auto value_of = [&](Reference reference) {
    return value_json(row, reference_value(object, row, index, reference), object);
  };
  entry["factory"] = value_of(Reference::Factory);
  entry["differs_from_factory"] = differs(object, placed, index, Reference::Factory);
  if (saved_.has(object.number())) entry["stored"] = value_of(Reference::Stored);
  entry["differs_from_stored"] = differs(object, placed, index, Reference::Stored);
  const auto* const presets = presets_of(instance_.configuration(), object);
  if (presets == nullptr) return;
  const auto preset = std::ranges::find_if(
      *presets, [&](const ParameterValue& value) { return value.number == row.number && value.index == index; });
  if (preset != presets->end())
    entry["preset"] = value_json(row, drive::transferred(row.type, preset->value), object);
}

void ParameterView::add_source(json& entry, const drive::DriveObject& object, const drive::ParameterRow& row,
                               std::uint32_t packed) const {
  if (packed <= drive::kHighestConstant) return;
  const drive::BicoSource source = drive::unpack(packed);
  const drive::DriveObject* const owner = object_of(unit_, object, source);
  const auto placed =
      owner != nullptr
          ? owner->parameter(source.number)
          : tl::unexpected{drive::ParameterError{drive::Refusal::NoDriveObject, source.number, nullptr}};
  json told{{"parameter",
             drive::bico_text({source.number, drive::kOwnObject, source.position}, row.type, object.number())},
            {"position", source.position}};
  if (owner != nullptr) told["axis"] = place_of(*owner);
  if (placed) {
    const bool is_index =
        row.type == drive::DataType::ConnectorInput || (*placed)->row->output == drive::Output::Bits;
    const std::size_t index = is_index ? source.position : 0U;
    told["name"] = (*placed)->row->name;
    if (index < (*placed)->row->count) {
      const drive::ParameterValue value = present(*owner, **placed, index);
      told["value"] =
          is_index ? value_json(*(*placed)->row, value, *owner) : json(value.bits >> (source.position & 31U) & 1U);
    }
  }
  entry["source"] = std::move(told);
}

void ParameterView::add_uses(json& entry, const drive::DriveObject& object, const drive::ParameterRow& row) const {
  if (row.output == drive::Output::No) return;
  const auto inputs = interconnections_.inputs_of(object.number(), row.number);
  json uses = json::array();
  for (const Interconnections::Input& input : inputs.first(std::min(inputs.size(), kMostUses)))
    uses.push_back({{"axis", place_of(*input.object)},
                    {"parameter", parameter_text(*input.row, input.index)},
                    {"position", input.position}});
  entry["used_by"] = std::move(uses);
  entry["uses"] = inputs.size();
}

json ParameterView::entry(const drive::DriveObject& object, const drive::PlacedRow& placed,
                          std::size_t index) const {
  const drive::ParameterRow& row = *placed.row;
  const drive::ParameterValue value = present(object, placed, index);
  json entry = definition(row);
  entry.update(identity(object, row, index));
  entry["value"] = value_json(row, value, object);
  add_access(entry, object, row);
  add_references(entry, object, placed, index);
  if (drive::is_bico_input(row.type)) add_source(entry, object, row, value.bits);
  add_uses(entry, object, row);
  return entry;
}

json ParameterView::difference(const drive::DriveObject& object, const drive::PlacedRow& placed, std::size_t index,
                               Reference reference) const {
  const drive::ParameterRow& row = *placed.row;
  json told = identity(object, row, index);
  told["value"] = value_json(row, present(object, placed, index), object);
  told["reference"] = value_json(row, reference_value(object, row, index, reference), object);
  return told;
}

}  // namespace axisd
