#include "cia402/objects/acting.hpp"

#include <algorithm>
#include <array>

#include "cia402/objects/object_index.hpp"

namespace cia402 {
namespace {

struct ActingRow {
  std::uint16_t index;
  Acting what;
};
constexpr std::array kRows{
    ActingRow{object::kControlword, Acting::Controlword},
    ActingRow{object::kVlTargetVelocity, Acting::VlVelocity},
    ActingRow{object::kModesOfOperation, Acting::Mode},
    ActingRow{object::kTargetTorque, Acting::Torque},
    ActingRow{object::kTargetPosition, Acting::Position},
    ActingRow{object::kPositionOffset, Acting::Position},
    ActingRow{object::kVelocityOffset, Acting::Velocity},
    ActingRow{object::kTorqueOffset, Acting::Torque},
    ActingRow{object::kTouchProbeFunction, Acting::Probe},
    ActingRow{object::kInterpolationData, Acting::Interpolation},
    ActingRow{object::kTargetVelocity, Acting::Velocity},
};

}  // namespace

ActingSet acting_of(std::uint16_t index) noexcept {
  const auto* const row = std::ranges::find(kRows, index, &ActingRow::index);
  return row != kRows.end() ? bit_of(row->what) : ActingSet{0};
}

}  // namespace cia402
