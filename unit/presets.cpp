#include "unit/presets.hpp"

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
  for (std::size_t i = 0; i < configuration_.axis_presets.size(); ++i)
    for (const ParameterPreset& preset : configuration_.axis_presets[i])
      if (belongs(group, unit_.axes()[i].kind(), preset)) apply(unit_.axes()[i], preset);
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
