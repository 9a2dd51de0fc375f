#include "can/hub/member/raw_member.hpp"

#include <cerrno>
#include <new>
#include <utility>

#include <sys/socket.h>

namespace hub {

using userbus::OptionName;

RawMember::RawMember(Core& core, os::Descriptor socket, userbus::Kind kind)
    : Member{core, std::move(socket), kind} {
  core.medium.attach(*this);
}

RawMember::~RawMember() {
  core().medium.detach(*this);
}

void RawMember::receive(const Passage& passage) noexcept {
  if (!wants(passage)) return;
  const bool own = passage.sender == this;
  userbus::FrameMessage message{.frame = passage.frame, .trailer = {}};
  message.trailer.flags =
      static_cast<std::uint32_t>((passage.local ? MSG_DONTROUTE : 0) | (own ? MSG_CONFIRM : 0));
  message.trailer.time_ns = passage.time_ns;
  message.trailer.dropped = dropped();
  message.trailer.interface_index = interface_index();
  if (interface_index() == 0)
    message.trailer.interface_index =
        passage.interface_index != 0 ? passage.interface_index : core().interfaces.common_index();
  if (is_bridge()) {
    message.trailer.flags |= passage.mark.number << userbus::kOriginShift;
    message.trailer.origin = passage.mark.hub;
  }
  deliver(std::as_bytes(std::span{&message, 1}));
}

bool RawMember::wants(const Passage& passage) const noexcept {
  if (interface_index() < 0 || (passage.local && !passage.loopback)) return false;
  if (passage.sender == this && option(OptionName::OwnMessages) == 0) return false;
  return filters_.passes(passage.frame.can_id);
}

bool RawMember::take_frame(const Sent& sent, canopen::TimePoint now) noexcept {
  if (!core().medium.is_new(sent.mark)) return false;
  const Passage passage{.frame = sent.frame,
                        .sender = this,
                        .interface_index = sent.interface_index,
                        .loopback = option(OptionName::Loopback) != 0,
                        .local = true,
                        .mark = sent.mark};
  if (waiting_ == 0 && core().medium.send(passage, now)) return true;
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

int RawMember::set_filters(std::span<const can_filter> filters) noexcept {
  if (filters.size() > CAN_RAW_FILTER_MAX) return EINVAL;
  try {
    filters_.assign(filters);
  } catch (const std::bad_alloc&) {
    return ENOMEM;
  }
  return 0;
}

void RawMember::option_changed(OptionName name, std::uint32_t value) noexcept {
  if (name == OptionName::ErrorFilter) filters_.set_error_mask(value);
  if (name == OptionName::JoinFilters) filters_.set_joined(value != 0);
}

}  // namespace hub
