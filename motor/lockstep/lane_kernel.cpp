// A group of axes in lanes, for one kind of processor: this file is compiled for each, as MOTOR_LANES_NAME, with
// the registers of which it shall be known under MOTOR_LANES_FORM and MOTOR_LANES_SUPPORTED.
#include "motor/lockstep/lane_passage.hpp"
#include "motor/lockstep/lane_step.hpp"
#include "motor/lockstep/twin.hpp"

namespace motor {

#ifdef MOTOR_LANES_TWIN
using NativeLanes = Twin<std::experimental::native_simd<double>>;
#else
using NativeLanes = std::experimental::native_simd<double>;
#endif

extern const LaneVariant MOTOR_LANES;
const LaneVariant MOTOR_LANES{
    .name = MOTOR_LANES_NAME,
    .lanes = kLanes<NativeLanes>,
    .size = sizeof(LaneTrain<NativeLanes>),
    .is_supported = []() noexcept -> bool { return MOTOR_LANES_SUPPORTED; },
    .form = [](void* storage, const LaneKind& kind, std::span<const AxisRun* const> axes) noexcept -> LaneGroup* {
      return new (storage) LaneTrain<NativeLanes>{kind, axes};
    }};

}  // namespace motor
