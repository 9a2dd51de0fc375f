#include "can/hub/member/member.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <linux/can/error.h>
#include <poll.h>

#include "can/hub/member/requests.hpp"

namespace hub {

namespace {

pid_t process_of(int socket) noexcept {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 ? peer.pid : 0;
}

/// Whether the far end is closed: else a message of no bytes is one.
bool has_hung_up(int socket) noexcept {
  pollfd wanted{socket, POLLRDHUP, 0};
  return poll(&wanted, 1, 0) != 0;
}

}  // namespace

Member::Member(Core& core, os::Descriptor socket, userbus::Kind kind)
    : core_{core},
      socket_{std::move(socket)},
      outbox_{socket_.get()},
      kind_{kind},
      process_{process_of(socket_.get())} {
  options_[static_cast<std::size_t>(userbus::OptionName::Loopback)] = 1;
  core_.gathering.reserve(core_.members.size() + 1);
}

Member::~Member() {
  core_.poll.remove(socket_.get(), *this);
  core_.interfaces.release(interface_index_);
}

void Member::bind(int interface_index) noexcept {
  core_.interfaces.hold(interface_index);
  core_.interfaces.release(interface_index_);
  interface_index_ = interface_index;
  bound();
  if (!core_.medium.is_up()) tell_link(false);
}

void Member::tell_link(bool up) noexcept {
  if (interface_index_ < 0 || (up && kind_ != userbus::Kind::Port)) return;
  userbus::FrameMessage message{};
  message.frame.can_id = CAN_ERR_FLAG;
  message.frame.can_dlc = CAN_ERR_DLC;
  message.trailer.interface_index = interface_index_;
  message.trailer.flags = up ? userbus::kLinkUp : userbus::kLinkDown;
  message.trailer.dropped = dropped();
  note_given();
  const bool was_empty = outbox_.empty();
  if (!outbox_.offer(std::as_bytes(std::span{&message, 1}))) is_cut_untold_ = true;
  if (was_empty && !outbox_.empty()) update_watch();
}

/// A program that did not read learns of a cut behind what was kept for it, and then that it is over.
void Member::flush() noexcept {
  outbox_.flush();
  if (!std::exchange(is_cut_untold_, false)) return;
  tell_link(false);
  if (core_.medium.is_up()) tell_link(true);
}

std::size_t Member::drain(bool is_asked) noexcept {
  constexpr std::size_t kMost = 1024;  // a program that sends on and on must not hold the hub
  std::size_t count = 0;
  while (count < kMost) {
    const std::size_t most = std::max<std::size_t>(may_read(), is_asked ? 1 : 0);
    const std::size_t taken = most == 0 ? 0 : read(most);
    count += taken;
    if (taken < most || taken == 0) break;  // fewer than there is room for: it is empty
  }
  unread_ -= std::min(unread_, count);
  go_on();
  if (count >= kMost && core_.clock.is_told()) core_.poll.change(socket_.get(), watched_, *this);
  return count;
}

bool Member::catch_up() noexcept {
  if (outbox_.empty()) return false;
  const std::size_t before = outbox_.waiting();
  flush();
  update_watch();
  return outbox_.waiting() != before;
}

bool Member::begin() noexcept {
  watched_ = EPOLLIN | EPOLLRDHUP | (core_.clock.is_told() ? EPOLLET : 0U);
  can_look_ = core_.clock.is_told() && Inbox::prepare_to_look(socket_.get());
  return core_.poll.add(socket_.get(), watched_, *this);
}

void Member::on_events(std::uint32_t events) noexcept {
  if (core_.clock.is_told()) return on_events_of_turns(events);
  if ((events & EPOLLOUT) != 0) flush();
  if (phase_ == Phase::Open && (events & (EPOLLRDHUP | EPOLLHUP | EPOLLERR)) != 0) phase_ = Phase::Closed;
  if (const std::size_t most = may_read(); most > 0) read(most);
  go_on();
}

/// The number of messages; 0 if there was nothing, or a message of no bytes, as which the end is read.
std::size_t Member::read(std::size_t most) noexcept {
  const int count = core_.inbox.receive(socket_.get(), most);
  if (count < 0) {
    // a program that leaves messages unread resets the connection; what it had sent before is still there
    const bool again = errno == EAGAIN || errno == EINTR || errno == ECONNRESET;
    if (!again) phase_ = Phase::ReadOut;
    return 0;
  }
  const canopen::TimePoint now = core_.clock.now();
  bool last_is_empty = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    Inbox::Message message = core_.inbox.take(i, core_.closer);
    last_is_empty = message.bytes.empty();
    if (!last_is_empty) take(std::move(message), now);
  }
  if (!last_is_empty) return static_cast<std::size_t>(count);
  if (core_.clock.is_told() && phase_ == Phase::Open) {
    if (!has_hung_up(socket_.get())) return static_cast<std::size_t>(count);
    phase_ = Phase::Closed;
  }
  if (phase_ == Phase::Closed) phase_ = Phase::ReadOut;
  return 0;
}

void Member::take(Inbox::Message message, canopen::TimePoint read_at) noexcept {
  // where the clock is told, a frame before this message may have had time go on
  const canopen::TimePoint now = core_.clock.told_or(read_at);
  const bool is_request = static_cast<bool>(message.descriptor);
  const bool taken = is_request ? answer_request({core_, *this, now}, message)
                                : message.complete && take_message(message.bytes, now);
  if (!taken) ++refused_;
  // its process waits for the answer as for anything else; a raw socket's does so at once
  if (is_request && kind_ == userbus::Kind::Port) note_given();
}

/// One frame, or one to most_taken_ with trailers; of several each counts by itself.
bool Member::take_frames(std::span<const std::byte> bytes, canopen::TimePoint now) noexcept {
  userbus::FrameMessage message{};
  if (bytes.size() == sizeof message.frame) {
    std::memcpy(&message.frame, bytes.data(), bytes.size());
    return take_frame(message, now);
  }
  const std::size_t count = bytes.size() / sizeof message;
  if (bytes.size() % sizeof message != 0 || count > most_taken_) return false;
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(&message, &bytes[i * sizeof message], sizeof message);
    if (!take_frame(message, now)) ++refused_;
  }
  return true;
}

bool Member::take_frame(const userbus::FrameMessage& message, canopen::TimePoint now) noexcept {
  if (core_.turns != nullptr) now = core_.turns->time_of_sending(process_, message.trailer.time_ns);
  const int named = message.trailer.interface_index;
  const int interface_index = named == 0 ? interface_index_ : named;
  if (message.frame.can_dlc > CAN_MAX_DLEN || core_.interfaces.name_of(interface_index).empty()) return false;
  bus::Mark mark;
  if (is_bridge_) mark = {.hub = message.trailer.origin, .number = message.trailer.flags >> userbus::kOriginShift};
  if (!take_frame(Sent{message.frame, interface_index, mark}, now)) return false;
  count_sent();
  return true;
}

void Member::deliver(std::span<const std::byte> message) noexcept {
  if (kind_ != userbus::Kind::Clock) note_given();
  const bool was_empty = outbox_.empty();
  outbox_.send(message);
  if (was_empty && !outbox_.empty()) update_watch();
}

void Member::begin_gathering() noexcept {
  if (outbox_.is_full()) write_gathered();
  if (!std::exchange(is_gathering_, true)) core_.gathering.push_back(this);
}

void Member::set_most_frames(std::size_t most, std::size_t most_taken) noexcept {
  write_gathered();
  outbox_.set_most_frames(most);
  most_taken_ = most_taken;
}

void Member::go_on() noexcept {
  if (phase_ == Phase::ReadOut && is_done()) {
    phase_ = Phase::Departed;
    core_.anyone_departed = true;
  }
  update_watch();
}

void Member::update_watch() noexcept {
  std::uint32_t wanted = 0;
  if (phase_ == Phase::Open) wanted = outbox_.empty() ? EPOLLRDHUP : EPOLLRDHUP | EPOLLOUT;
  if (phase_ <= Phase::Closed && may_read() > 0) wanted |= EPOLLIN;
  if (core_.clock.is_told()) wanted = watch_of_turns(wanted);
  if (wanted == watched_) return;
  // a hang-up would be told for ever: who is not to be read any more is not watched
  if (wanted == 0)
    core_.poll.remove(socket_.get(), *this);
  else if (watched_ != 0)
    core_.poll.change(socket_.get(), wanted, *this);
  else if (!core_.poll.add(socket_.get(), wanted, *this))
    phase_ = Phase::ReadOut;
  watched_ = wanted;
}

int Member::set_option(const userbus::Option& option) noexcept {
  const auto number = static_cast<std::size_t>(option.name);
  if (number >= options_.size()) return EINVAL;
  options_[number] = option.value;
  option_changed(option.name, option.value);
  return 0;
}

int Member::set_filters(std::span<const can_filter>) noexcept {
  return EOPNOTSUPP;
}

int Member::broadcast(std::span<const std::byte>, int, canopen::TimePoint) noexcept {
  return EOPNOTSUPP;
}

userbus::MemberState Member::state() const noexcept {
  userbus::MemberState state{.interface_index = interface_index_,
                             .bit_rate = core_.medium.bit_rate(),
                             .options = {},
                             .dropped = outbox_.dropped()};
  std::ranges::copy(options_, state.options);
  return state;
}

Identity Member::who() const noexcept {
  Identity who{.process = process_, .interface_index = interface_index_};
  std::strncpy(who.name.data(), userbus::kKindNames[static_cast<std::size_t>(kind_)], who.name.size() - 1);
  return who;
}

userbus::MemberStatistics Member::statistics() const noexcept {
  userbus::MemberStatistics row{.name = {},
                                .process = process_,
                                .interface_index = interface_index_,
                                .sent = sent_,
                                .received = outbox_.taken(),
                                .dropped = outbox_.dropped(),
                                .refused = refused_};
  std::strncpy(row.name, userbus::kKindNames[static_cast<std::size_t>(kind_)], sizeof row.name - 1);
  return row;
}

}  // namespace hub
