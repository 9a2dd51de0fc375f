// A group of axes in lanes, for one kind of processor: this file is compiled for each, as the LaneVariant
// MOTOR_LANES with the name MOTOR_LANES_NAME, where MOTOR_LANES_SUPPORTED holds; with MOTOR_LANES_TWIN each number
// is two registers.
#include "motor/lockstep/lane_passage.hpp"
#include "motor/lockstep/lane_step.hpp"
#include "motor/lockstep/twin.hpp"

#if defined(__SSE2__) && !defined(__AVX__)
#include "motor/lockstep/sse2_lanes.hpp"
#endif

namespace motor {

#if defined(__SSE2__) && !defined(__AVX__)
using Register = Sse2Lanes;
#else
using Register = std::experimental::native_simd<double>;
#endif
#ifdef MOTOR_LANES_TWIN
using NativeLanes = Twin<Register>;
#else
using NativeLanes = Register;
#endif

extern const LaneVariant MOTOR_LANES;
const LaneVariant MOTOR_LANES{
    .name = MOTOR_LANES_NAME,
    .lanes = kLanes<NativeLanes>,
    .size = sizeof(LaneTrain<NativeLanes>),
    .is_supported = []() noexcept -> bool { return MOTOR_LANES_SUPPORTED; },
    .form = [](void* storage, const LaneKind& kind, std::span<const LaneAxis> axes) noexcept -> LaneGroup* {
      return new (storage) LaneTrain<NativeLanes>{kind, axes};
    }};

}  // namespace motor
