#include "can/hub/member/raw_member.hpp"

#include <algorithm>
#include <cerrno>
#include <new>
#include <utility>

#include <sys/socket.h>

namespace hub {

using userbus::OptionName;

RawMember::RawMember(Core& core, os::Descriptor socket, userbus::Kind kind)
    : Member{core, std::move(socket), kind}, kept_(std::max(Inbox::kBatch, userbus::kMostFrames)) {
  core.medium.attach(*this);
  core.medium.hear_nothing(*this);
}

RawMember::~RawMember() {
  core().medium.detach(*this);
}

/// Its filters have let the frame pass.
void RawMember::receive(const Passage& passage) noexcept {
  const bool own = passage.sender == this;
  if ((passage.local && !passage.loopback) || (own && option(OptionName::OwnMessages) == 0)) return;
  userbus::FrameMessage& message = gather();
  message.frame = passage.frame;
  message.trailer = {
      .interface_index = interface_index(),
      .flags = static_cast<std::uint32_t>((passage.local ? MSG_DONTROUTE : 0) | (own ? MSG_CONFIRM : 0)),
      .time_ns = passage.time_ns,
      .dropped = dropped(),
      .origin = 0};
  if (interface_index() == 0)
    message.trailer.interface_index =
        passage.interface_index != 0 ? passage.interface_index : core().interfaces.common_index();
  if (!is_bridge()) return;
  message.trailer.flags |= passage.mark.number << userbus::kOriginShift;
  message.trailer.origin = passage.mark.hub;
}

bool RawMember::take_frame(const Sent& sent, canopen::TimePoint now) noexcept {
  if (!core().medium.is_new(sent.mark)) return false;
  const Passage passage{.frame = sent.frame,
                        .sender = this,
                        .interface_index = sent.interface_index,
                        .loopback = option(OptionName::Loopback) != 0,
                        .local = true,
                        .mark = sent.mark};
  return (waiting_ == 0 && core().medium.send(passage, now)) || keep(passage);
}

/// False if there is no memory for more than come with one system call in messages of one frame, or in one message
/// of many: with a bit rate that is all that can be kept.
bool RawMember::keep(const Passage& passage) noexcept {
  if (waiting_ == kept_.size()) {
    try {
      kept_.reserve(2 * kept_.size());
    } catch (const std::bad_alloc&) {
      return false;
    }
    std::rotate(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(std::exchange(next_, 0)), kept_.end());
    kept_.resize(2 * kept_.size());
  }
  kept_[(next_ + waiting_++) % kept_.size()] = passage;
  return true;
}

void RawMember::on_room() noexcept {
  for (; waiting_ > 0; --waiting_) {
    if (!core().medium.send(kept_[next_], core().medium.now())) break;
    next_ = (next_ + 1) % kept_.size();
  }
  go_on();
}

/// With a bit rate one at a time: what the bus cannot take yet stays in the socket, whose room is what tells the
/// program that it is too fast.
std::size_t RawMember::may_read() const noexcept {
  if (waiting_ > 0) return 0;
  return core().medium.bit_rate() == 0 ? Inbox::kBatch : 1;
}

/// Where sending has to wait for the bus the program sends one frame at a time: its room in the socket is what
/// tells it that it is too fast.
std::size_t RawMember::agree_on_frames(std::size_t most) noexcept {
  const bool waits = core().medium.bit_rate() != 0 || core().medium.carrier() != nullptr;
  const std::size_t taken = most > 1 && !waits ? userbus::kMostFrames : 1;
  set_most_frames(std::min(most, userbus::kMostFrames), taken);
  return taken;
}

int RawMember::set_filters(std::span<const can_filter> filters) noexcept {
  if (filters.size() > CAN_RAW_FILTER_MAX) return EINVAL;
  try {
    filters_.assign(filters);
  } catch (const std::bad_alloc&) {
    return ENOMEM;
  }
  filters_changed();
  return 0;
}

void RawMember::option_changed(OptionName name, std::uint32_t value) noexcept {
  if (name == OptionName::ErrorFilter) filters_.set_error_mask(value);
  if (name == OptionName::JoinFilters) filters_.set_joined(value != 0);
  if (name == OptionName::ErrorFilter || name == OptionName::JoinFilters) filters_changed();
}

void RawMember::filters_changed() noexcept {
  if (interface_index() >= 0) core().medium.hear(*this, filters_);
}

}  // namespace hub
