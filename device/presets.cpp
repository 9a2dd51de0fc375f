#include "device/presets.hpp"

#include <cassert>

#include "device/mirrored_parameters.hpp"

namespace device {
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
  for (std::size_t i = 0; i < configuration_.axes.size(); ++i) {
    drive::Axis& axis = unit_.axes()[i];
    for (const ParameterPreset& preset : configuration_.axes[i].presets) {
      if (!belongs_to(group, preset.number)) continue;
      const bool shown = MirroredParameters::contains(axis.kind(), preset.number);
      const bool provided = axis.provides(*drive::find_parameter(axis.kind(), preset.number)->row);
      [[maybe_unused]] const auto done = shown || !provided
                                             ? axis.load(preset.number, preset.index, preset.value)
                                             : axis.write(preset.number, preset.index, preset.value);
      assert(done);
    }
  }
}

}  // namespace device
