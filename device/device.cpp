// A turn in halves, between which the steps of a cycle are made with those of other units.
#include "device/device.hpp"

namespace device {

drive::DriveUnit* Device::begin_time(canopen::TimePoint now) noexcept {
  runner_.set_now(unit_time(now));
  face_->before_cycles();
  drive::DriveUnit* const unit = runner_.begin_due();
  if (unit == nullptr) face_->after_cycles();
  return unit;
}

void Device::finish_time() noexcept {
  runner_.finish_due();
  face_->after_cycles();
}

}  // namespace device
