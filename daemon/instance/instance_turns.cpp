// What an instance does when its time has come, alone or with other units, and who stands at its bus in its place.
#include <algorithm>

#include "daemon/instance/instance.hpp"
#include "service/clock.hpp"

namespace axisd {

void Instance::on_time(canopen::TimePoint now) noexcept {
  cycle_due_ = device_.next_cycle();
  device_.on_time(now);
  end_time(now);
}

drive::DriveUnit* Instance::begin_time(canopen::TimePoint now) noexcept {
  cycle_due_ = device_.next_cycle();
  drive::DriveUnit* const unit = device_.begin_time(now);
  if (unit == nullptr) end_time(now);
  return unit;
}

void Instance::finish_time(canopen::TimePoint now) noexcept {
  device_.finish_time();
  end_time(now);
}

void Instance::end_time(canopen::TimePoint now) noexcept {
  memory_.on_time(now);
  if (cycle_due_ <= now) cycle_times_.note(cycle_due_, now, read_clock(), device_.cycle());
}

void Instance::Heard::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  instance_.frames_.on_frame(frame, now);
  if (instance_.faults_.is_empty())
    instance_.on_frame(frame, now);
  else
    instance_.faults_.on_frame(frame, now);
  instance_.frames_.on_handled();
}

/// Also when nothing of the unit itself was due.
void Instance::Heard::on_time(canopen::TimePoint now) noexcept {
  instance_.frames_.on_time(now);
  instance_.faults_.on_time(now);
  instance_.on_time(now);
  instance_.faults_.settle(now);
  instance_.frames_.on_handled();
}

canopen::TimePoint Instance::Heard::next_deadline() const noexcept {
  return std::min(
      {instance_.next_deadline(), instance_.frames_.next_deadline(), instance_.faults_.next_deadline()});
}

std::span<const canopen::Subscription> Instance::Heard::subscriptions() const noexcept {
  return instance_.faults_.is_empty() ? instance_.subscriptions() : instance_.faults_.subscriptions();
}

}  // namespace axisd
