#include "unit/presets.hpp"

#include <algorithm>
#include <cassert>

namespace unit {

void Presets::apply(ParameterGroup group) noexcept {
  for (const ParameterPreset& preset : configuration_.presets) {
    if (!belongs(group, drive::ObjectKind::ControlUnit, preset)) continue;
    [[maybe_unused]] const auto done =
        unit_.object(drive::kControlUnitNumber)->load(preset.number, preset.index, preset.value);
    assert(done);
  }
  for (const ParameterPreset& preset : configuration_.infeed_presets) {
    // An infeed that operates keeps what is for one that is off.
    if (belongs(group, drive::ObjectKind::Infeed, preset))
      static_cast<void>(unit_.infeed()->write(preset.number, preset.index, preset.value));
  }
  for (std::size_t i = 0; i < configuration_.axis_deliveries.size(); ++i) {
    const Delivery& delivery = configuration_.axis_deliveries[i];
    if (has_identity(i)) continue;
    apply(group, unit_.axes()[i], delivery.identity);
    apply(group, unit_.axes()[i], delivery.values);
  }
  for (std::size_t i = 0; i < configuration_.axis_presets.size(); ++i)
    apply(group, unit_.axes()[i], configuration_.axis_presets[i]);
}

/// Whether axis @p i has the identity of its delivery, as its own presets leave it.
bool Presets::has_identity(std::size_t i) const noexcept {
  const auto is_preset = [&](const ParameterPreset& value) {
    return i < configuration_.axis_presets.size() &&
           std::ranges::any_of(configuration_.axis_presets[i], [&](const ParameterPreset& preset) {
             return preset.number == value.number && preset.index == value.index;
           });
  };
  return std::ranges::all_of(configuration_.axis_deliveries[i].identity, [&](const ParameterPreset& value) {
    const double present = unit_.axes()[i].kept_value(value.number, value.index).value_or(0.0);
    return !(present < value.value || present > value.value) || is_preset(value);
  });
}

void Presets::apply(ParameterGroup group, drive::Axis& axis, std::span<const ParameterPreset> presets) noexcept {
  for (const ParameterPreset& preset : presets)
    if (belongs(group, axis.kind(), preset)) apply(axis, preset);
}

bool Presets::belongs(ParameterGroup group, drive::ObjectKind kind, const ParameterPreset& preset) const noexcept {
  return known_.groups.contains(group, *drive::find_parameter(kind, preset.number)->row);
}

void Presets::apply(drive::Axis& axis, const ParameterPreset& preset) noexcept {
  const drive::ParameterRow& row = *drive::find_parameter(axis.kind(), preset.number)->row;
  const bool is_loaded = !axis.provides(row) || known_.homes.is_elsewhere({axis, row, preset.index});
  [[maybe_unused]] const auto done = is_loaded ? axis.load(preset.number, preset.index, preset.value)
                                               : axis.write(preset.number, preset.index, preset.value);
  assert(done);
}

}  // namespace unit
