#include "can/hub/broadcast/reception.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace hub::broadcast {

namespace {

std::uint64_t data_of(const can_frame& frame) noexcept {
  std::uint64_t data = 0;
  static_assert(sizeof data == sizeof frame.data);
  std::memcpy(&data, frame.data, sizeof data);
  return data;
}

}  // namespace

Request Reception::normal(Request request) noexcept {
  if (request.head.nframes == 0) request.head.flags |= RX_FILTER_ID;
  if ((request.head.flags & RX_FILTER_ID) != 0) request.head.nframes = 0;
  return request;
}

int Reception::check(const Request& request) noexcept {
  const Head& head = request.head;
  if (head.nframes > kMostFrames) return EINVAL;
  const bool answers = (head.flags & RX_RTR_FRAME) != 0;
  if (answers && (head.nframes != 1 || (head.can_id & CAN_RTR_FLAG) == 0)) return EINVAL;
  return has_valid_intervals(head) ? 0 : EINVAL;
}

Reception::Reception(const Outlet& outlet, const Request& request)
    : outlet_{outlet},
      settings_{.can_id = request.head.can_id, .interface_index = request.interface_index},
      last_interface_{request.interface_index} {}

int Reception::set_up(const Request& request) {
  const bool is_new = last_.empty();
  if (!is_new && request.head.nframes > filters_.size()) return E2BIG;
  if (const int error = take_filters(request); error != 0) return error;
  if (is_new) last_.resize(std::max<std::size_t>(1, filters_.size()));
  settings_.flags = request.head.flags;
  if (!answers_remote_frames()) {
    restart(request);
    return 0;
  }
  timeout_due_ = canopen::kNever;
  throttle_due_ = canopen::kNever;
  // answering with a remote frame of the same identifier would ask for the next answer
  can_frame& answer = filters_.front();
  if ((settings_.flags & TX_CP_CAN_ID) != 0 || answer.can_id == settings_.can_id)
    answer.can_id = settings_.can_id & ~CAN_RTR_FLAG;
  return 0;
}

int Reception::take_filters(const Request& request) {
  const std::size_t count = request.head.nframes;
  if (count > 0 && !request.has_frame(count - 1)) return EFAULT;
  const bool is_answer = (request.head.flags & RX_RTR_FRAME) != 0;
  if (is_answer && request.frame(0).can_dlc > CAN_MAX_DLEN) return EINVAL;
  filters_.resize(count);
  for (std::size_t i = 0; i < count; ++i) filters_[i] = request.frame(i);
  std::fill_n(last_.begin(), std::min(count, last_.size()), Last{});
  return 0;
}

void Reception::restart(const Request& request) noexcept {
  if ((settings_.flags & SETTIMER) != 0) {
    settings_.take_intervals(request.head);
    if (settings_.first() == canopen::Duration::zero()) timeout_due_ = canopen::kNever;
    last_told_.reset();
    throttle_due_ = canopen::kNever;
    tell_held_back();
  }
  if ((settings_.flags & STARTTIMER) != 0 && settings_.first() != canopen::Duration::zero())
    timeout_due_ = request.now + settings_.first();
}

void Reception::on_time(canopen::TimePoint now) noexcept {
  if (timeout_due_ <= now) tell_timeout();
  if (throttle_due_ > now) return;
  if (tell_held_back()) {
    throttle_due_ = next_of_cycle(throttle_due_ + settings_.second(), settings_.second(), now);
    return;
  }
  throttle_due_ = canopen::kNever;
  last_told_.reset();
}

void Reception::receive(const Passage& passage, canopen::TimePoint now) noexcept {
  if (passage.frame.can_id != settings_.can_id) return;
  timeout_due_ = canopen::kNever;
  if (answers_remote_frames()) {
    answer_remote_frame(now);
    return;
  }
  last_interface_ = settings_.interface_index != 0 ? settings_.interface_index : passage.interface_index;
  compare(passage.frame, now);
  if ((settings_.flags & RX_NO_AUTOTIMER) == 0 && settings_.first() != canopen::Duration::zero())
    timeout_due_ = now + settings_.first();
}

void Reception::answer_remote_frame(canopen::TimePoint now) noexcept {
  if (settings_.interface_index != 0) outlet_.send(filters_.front(), settings_.interface_index, now);
}

void Reception::compare(const can_frame& frame, canopen::TimePoint now) noexcept {
  if ((settings_.flags & RX_FILTER_ID) != 0) {
    take_content(frame, last_.front(), now);
    return;
  }
  const auto index = filter_of(frame);
  if (index && differs(frame, *index)) take_content(frame, last_[*index], now);
}

/// Which filter @p frame is to be compared by: the only one, or the first that has its multiplexing bits.
std::optional<std::size_t> Reception::filter_of(const can_frame& frame) const noexcept {
  if (filters_.size() == 1) return 0;
  const std::uint64_t mask = data_of(filters_.front());
  for (std::size_t i = 1; i < filters_.size(); ++i)
    if ((data_of(frame) & mask) == (data_of(filters_[i]) & mask)) return i;
  return std::nullopt;
}

bool Reception::differs(const can_frame& frame, std::size_t index) const noexcept {
  const Last& last = last_[index];
  if (!last.received) return true;
  const std::uint64_t mask = data_of(filters_[index]);
  if (frame.can_dlc > 0 && (data_of(frame) & mask) != (data_of(last.frame) & mask)) return true;
  return (settings_.flags & RX_CHECK_DLC) != 0 && frame.can_dlc != last.frame.can_dlc;
}

/// Keeps the new content, and tells it unless the throttling period forbids that for now.
void Reception::take_content(const can_frame& frame, Last& last, canopen::TimePoint now) noexcept {
  last = {.frame = frame, .received = true, .held_back = true};
  const canopen::Duration throttle = settings_.second();
  if (throttle == canopen::Duration::zero()) {
    tell_change(last);
    return;
  }
  if (throttle_due_ != canopen::kNever) return;
  if (last_told_ && now - *last_told_ < throttle) {
    throttle_due_ = *last_told_ + throttle;
    return;
  }
  tell_change(last);
  last_told_ = now;
}

void Reception::tell_change(Last& last) noexcept {
  last.held_back = false;
  outlet_.tell(settings_.head(RX_CHANGED), {&last.frame, 1}, last_interface_);
}

/// False if nothing was held back.
bool Reception::tell_held_back() noexcept {
  bool told = false;
  for (std::size_t i = filters_.size() > 1 ? 1 : 0; i < std::max<std::size_t>(1, filters_.size()); ++i) {
    if (!last_[i].held_back) continue;
    tell_change(last_[i]);
    told = true;
  }
  return told;
}

void Reception::tell_timeout() noexcept {
  timeout_due_ = canopen::kNever;
  if ((settings_.flags & RX_ANNOUNCE_RESUME) != 0)
    std::fill_n(last_.begin(), std::min(filters_.size(), last_.size()), Last{});
  outlet_.tell(settings_.head(RX_TIMEOUT), {}, last_interface_);
}

}  // namespace hub::broadcast
