#include <algorithm>
#include <array>

#include "motor/lockstep/lane_group.hpp"

namespace motor {

extern const LaneVariant kBaselineLanes;
#ifdef MOTOR_WIDE_LANES
extern const LaneVariant kAvx2Lanes;
extern const LaneVariant kAvx512Lanes;
#endif

namespace {

const std::array kVariants{
#ifdef MOTOR_WIDE_LANES
    &kAvx512Lanes,
    &kAvx2Lanes,
#endif
    &kBaselineLanes,
};

const LaneVariant*& used() noexcept {
  static const LaneVariant* variant = &widest_variant();
  return variant;
}

}  // namespace

std::span<const LaneVariant* const> lane_variants() noexcept {
  return kVariants;
}

const LaneVariant& widest_variant() noexcept {
  static const LaneVariant& widest =
      **std::ranges::find_if(kVariants, [](const LaneVariant* variant) { return variant->is_supported(); });
  return widest;
}

const LaneVariant& variant_in_use() noexcept {
  return *used();
}

void use(const LaneVariant& variant) noexcept {
  used() = &variant;
}

}  // namespace motor
