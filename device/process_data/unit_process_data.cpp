#include "device/process_data/unit_process_data.hpp"

namespace device {

UnitProcessData::UnitProcessData(canopen::Dictionary& dictionary, drive::DriveUnit& unit,
                                 const canopen::Node& node, unit::UnitParameters& parameters,
                                 const Listeners& listeners)
    : unit_{unit},
      node_{node},
      follow_ups_{listeners.follow_ups},
      rules_{dictionary, unit, node, {*this, listeners.alarm}},
      parameters_{buffers_, wiring_, rules_, parameters} {
  for (drive::Axis& axis : unit.axes()) {
    buffers_.emplace_back(dictionary, unit, axis);
    free_objects_.emplace_back(dictionary, unit, axis, buffers_.back());
    wiring_.emplace_back(axis, buffers_.back());
  }
}

void UnitProcessData::take_over(WiredBy wired) noexcept {
  rules_.limit();
  for (ProcessDataBuffers& buffers : buffers_) buffers.invalidate();
  for (StandardWiring& wiring : wiring_) {
    if (wired == WiredBy::Factory) wiring.follow_from_factory();
    if (wired == WiredBy::Saved) wiring.adopt();
  }
  mapping_changed_ = true;
  follow_mappings();
}

bool UnitProcessData::follow_mappings() noexcept {
  const bool all = mapping_changed_;
  mapping_changed_ = false;
  for (std::size_t i = 0; i < wiring_.size(); ++i) {
    const drive::Axis& axis = unit_.axes()[i];
    const SetpointPath path{axis.speed_setpoint().setpoint, axis.has_setpoint_channel()};
    if (!all && path == paths_[i]) continue;
    paths_[i] = path;
    wiring_[i].follow();
  }
  return all;
}

void UnitProcessData::show_state() noexcept {
  constexpr std::size_t kNoSetpoints = 0, kBusRuns = 2;
  const bool runs = node_.state() == canopen::NmtState::Operational;
  unit_.for_each_object([=](drive::DriveObject& object) {
    object.process_data().interface_state[kNoSetpoints] = !runs;
    object.process_data().interface_state[kBusRuns] = runs;
  });
}

}  // namespace device
