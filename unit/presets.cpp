#include "unit/presets.hpp"

#include <cassert>

namespace unit {

void Presets::apply(ParameterGroup group) noexcept {
  for (const ParameterPreset& preset : configuration_.presets) {
    if (!belongs_to(group, preset.number)) continue;
    [[maybe_unused]] const auto done =
        unit_.object(drive::kControlUnitNumber)->load(preset.number, preset.index, preset.value);
    assert(done);
  }
  for (const ParameterPreset& preset : configuration_.infeed_presets) {
    // An infeed that operates keeps what is for one that is off.
    if (belongs_to(group, preset.number))
      static_cast<void>(unit_.infeed()->write(preset.number, preset.index, preset.value));
  }
  for (std::size_t i = 0; i < configuration_.axis_presets.size(); ++i)
    for (const ParameterPreset& preset : configuration_.axis_presets[i])
      if (belongs_to(group, preset.number)) apply(unit_.axes()[i], preset);
}

void Presets::apply(drive::Axis& axis, const ParameterPreset& preset) noexcept {
  const drive::ParameterRow& row = *drive::find_parameter(axis.kind(), preset.number)->row;
  const bool is_loaded = !axis.provides(row) || parameters_.is_elsewhere({axis, row, preset.index});
  [[maybe_unused]] const auto done = is_loaded ? axis.load(preset.number, preset.index, preset.value)
                                               : axis.write(preset.number, preset.index, preset.value);
  assert(done);
}

}  // namespace unit
