#include "device/presets.hpp"

#include <cassert>

#include "device/mirrored_parameters.hpp"

namespace device {
namespace {

/// Calls @p visit for those presets that objects show, if @p mirrored, or for the others.
template <class Visit>
void for_each_preset(const Configuration& configuration, drive::DriveUnit& unit, bool mirrored, Visit visit) {
  for (std::size_t i = 0; i < configuration.axes.size(); ++i) {
    drive::Axis& axis = unit.axes()[i];
    for (const ParameterPreset& preset : configuration.axes[i].presets)
      if (MirroredParameters::contains(axis.kind(), preset.number) == mirrored) visit(axis, preset);
  }
}

}  // namespace

void Presets::apply() noexcept {
  for_each_preset(configuration_, unit_, false, [](drive::Axis& axis, const ParameterPreset& preset) {
    [[maybe_unused]] const auto written = axis.write(preset.number, preset.index, preset.value);
    assert(written);
  });
  apply_mirrored();
}

void Presets::apply_mirrored() noexcept {
  for_each_preset(configuration_, unit_, true, [](drive::Axis& axis, const ParameterPreset& preset) {
    [[maybe_unused]] const auto loaded = axis.load(preset.number, preset.index, preset.value);
    assert(loaded);
  });
}

}  // namespace device
