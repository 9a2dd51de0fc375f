#include "device/unit_process_data.hpp"

namespace device {

UnitProcessData::UnitProcessData(canopen::Dictionary& dictionary, drive::DriveUnit& unit,
                                 const canopen::Node& node, UnitParameters& parameters, AlarmListener& listener)
    : rules_{dictionary, unit, node, {*this, listener}}, parameters_{unit, buffers_, rules_, parameters} {
  for (const drive::Axis& axis : unit.axes()) {
    buffers_.emplace_back(dictionary, unit, axis, node);
    free_objects_.emplace_back(dictionary, unit, axis, buffers_.back());
  }
}

void UnitProcessData::take_over() noexcept {
  rules_.limit();
  for (ProcessDataBuffers& buffers : buffers_) buffers.invalidate();
}

void UnitProcessData::publish() noexcept {
  for (FreeObjects& objects : free_objects_) objects.publish();
}

}  // namespace device
