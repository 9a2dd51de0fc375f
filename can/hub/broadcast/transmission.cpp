#include "can/hub/broadcast/transmission.hpp"

#include <cerrno>

namespace hub::broadcast {

Transmission::Transmission(const Outlet& outlet, const Request& request)
    : outlet_{outlet}, settings_{.can_id = request.head.can_id, .interface_index = request.interface_index} {}

int Transmission::set_up(const Request& request) {
  const std::size_t before = frames_.size();
  if (before != 0 && request.head.nframes > before) return E2BIG;
  if (const int error = take_frames(request); error != 0) return error;
  settings_.flags = request.head.flags;
  if (before != frames_.size() || (settings_.flags & TX_RESET_MULTI_IDX) != 0) current_ = 0;
  if ((settings_.flags & SETTIMER) != 0) {
    settings_.count = request.head.count;
    settings_.take_intervals(request.head);
    if (settings_.first() == canopen::Duration::zero() && settings_.second() == canopen::Duration::zero())
      due_ = canopen::kNever;
  }
  if ((settings_.flags & STARTTIMER) != 0) settings_.flags |= TX_ANNOUNCE;
  if ((settings_.flags & TX_ANNOUNCE) != 0) send(request.now);
  if ((settings_.flags & STARTTIMER) != 0) start(request.now);
  return 0;
}

/// Takes all frames, or none if one is wrong.
int Transmission::take_frames(const Request& request) {
  const std::size_t count = request.head.nframes;
  for (std::size_t i = 0; i < count; ++i) {
    if (!request.has_frame(i)) return EFAULT;
    if (request.frame(i).can_dlc > CAN_MAX_DLEN) return EINVAL;
  }
  frames_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    frames_[i] = request.frame(i);
    if ((request.head.flags & TX_CP_CAN_ID) != 0) frames_[i].can_id = request.head.can_id;
  }
  return 0;
}

void Transmission::start(canopen::TimePoint now) noexcept {
  const canopen::Duration period = interval();
  due_ = period == canopen::Duration::zero() ? canopen::kNever : now + period;
}

void Transmission::on_time(canopen::TimePoint now) noexcept {
  if (now < due_) return;
  const bool counting = settings_.first() > canopen::Duration::zero() && settings_.count > 0;
  if (counting || settings_.second() != canopen::Duration::zero()) send(now);
  if (counting && settings_.count == 0 && (settings_.flags & TX_COUNTEVT) != 0)
    outlet_.tell(settings_.head(TX_EXPIRED), {}, 0);
  const canopen::Duration period = interval();
  due_ = period == canopen::Duration::zero() ? canopen::kNever : next_of_cycle(due_ + period, period, now);
}

/// A frame that the bus has no room for is lost: the cycle goes on with the next one.
void Transmission::send(canopen::TimePoint now) noexcept {
  outlet_.send(frames_[current_], settings_.interface_index, now);
  current_ = (current_ + 1) % frames_.size();
  if (settings_.count > 0) --settings_.count;
}

/// Time to the next frame, zero if there is none.
canopen::Duration Transmission::interval() const noexcept {
  if (settings_.count > 0 && settings_.first() > canopen::Duration::zero()) return settings_.first();
  return settings_.second();
}

}  // namespace hub::broadcast
