#include "can/port/user_bus/user_bus.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "can/port/wire.hpp"
#include "can/userbus/request.hpp"
#include "os/clock.hpp"
#include "os/own_program.hpp"

namespace bus {

namespace {

using userbus::JoinError;
using userbus::Operation;

// Messages that change nothing are skipped; this many a call, so that a burst of them cannot hold the caller.
constexpr int kSkippedMessages = 16;

/// When a frame is sent, on a bus that has a time of its own; 0 = now.
std::int64_t time_of_sending() noexcept {
  return os::other_time == nullptr ? 0 : os::other_time->monotonic().count();
}

userbus::Path path_of(const std::string& text) {
  userbus::Path path{};
  if (userbus::copy_path(text.c_str(), path)) return path;
  throw OpenError{fmt::format("{}: expected a path of at most {} bytes", text, userbus::kLongestPath)};
}

}  // namespace

std::string hub_program() {
  if (const char* const named = std::getenv("CAN_HUB"); named != nullptr && *named != '\0') return named;
  return os::program_folder() / "canhub";
}

UserBus::UserBus(const std::string& path) : entry_{path_of(path), hub_program()} {
  if (!pollable_.add(inbox_.descriptor(), EPOLLIN))
    throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
  using Progress = UserBusEntry::Progress;
  Progress progress = entry_.begin(wishes());
  while (progress == Progress::Waiting) {
    pollfd wanted{entry_.descriptor(), POLLIN, 0};
    ::poll(&wanted, 1, -1);  // its timer ends it
    progress = entry_.advance(wishes());
  }
  const bool is_in = progress == Progress::Member && come_in();
  const JoinError error = progress == Progress::Failed ? entry_.error() : JoinError::System;
  if (!is_in) throw OpenError{fmt::format("unix:{}: {}", path, userbus::text_of(error))};
}

UserBusEntry::Wishes UserBus::wishes() const noexcept {
  return {.filters = filters_.get(), .is_bridge = is_bridge_};
}

/// The entry has led to a member. False, with errno, if that cannot be watched.
bool UserBus::come_in() noexcept {
  socket_ = entry_.take_member();
  if (!pollable_.add(socket_.get(), EPOLLIN)) {
    socket_ = os::Descriptor{};
    return false;
  }
  if (is_unapplied_) apply();  // it may have changed behind the step that tells it
  look_at_link();
  return true;
}

/// What the hub says first to a member of a bus that is cut is that it is.
void UserBus::look_at_link() noexcept {
  userbus::FrameMessage message{};
  const ssize_t size = ::recv(socket_.get(), &message, sizeof message, MSG_DONTWAIT | MSG_PEEK);
  if (size != sizeof message || (message.trailer.flags & userbus::kLinkDown) == 0) return;
  ::recv(socket_.get(), &message, sizeof message, MSG_DONTWAIT);
  static_cast<void>(note_link(userbus::kLinkDown));
}

/// Takes what comes while the bus is cut, up to that it is whole again: nobody may be receiving then.
void UserBus::read_link() noexcept {
  userbus::FrameMessage message{};
  for (int i = 0; is_cut_ && i < kSkippedMessages; ++i) {
    const FrameInbox::Outcome outcome = inbox_.next(socket_.get(), message);
    if (outcome == FrameInbox::Outcome::Gone) return static_cast<void>(hub_lost());
    if (outcome == FrameInbox::Outcome::Nothing) return;
    static_cast<void>(note_link(message.trailer.flags));
  }
}

/// Tells the hub what has changed. If it has no room at present, the next frame tells it, before it goes.
void UserBus::apply() noexcept {
  const auto filters = filters_.get();
  const os::Descriptor set{
      userbus::post(socket_.get(), Operation::SetFilters, 0, filters.data(), filters.size_bytes())};
  is_unapplied_ = !set;
  if (!is_bridge_ || is_unapplied_) return;
  const os::Descriptor hello{
      userbus::post(socket_.get(), Operation::Hello, 1, &UserBusEntry::kMostFrames, sizeof(std::uint32_t))};
  is_unapplied_ = !hello;
}

void UserBus::accept_only(std::span<const Filter> filters) noexcept {
  filters_.assign(filters);
  is_unapplied_ = true;
  if (is_member()) apply();
}

void UserBus::carry_marks() noexcept {
  is_bridge_ = true;
  is_unapplied_ = true;
  if (is_member()) apply();
}

bool UserBus::try_again() noexcept {
  if (is_member()) {
    entry_.stop_ringing();
    if (is_cut_) read_link();
    if (is_mended_) entry_.stop_ringing();
    return std::exchange(is_mended_, false);
  }
  const UserBusEntry::Progress progress = entry_.advance(wishes());
  if (progress == UserBusEntry::Progress::Waiting) return false;
  if (progress == UserBusEntry::Progress::Member && come_in()) return is_up();
  entry_.try_later(/*first=*/false);
  return false;
}

bool UserBus::reopen() noexcept {
  constexpr int kMost = 1 << 20;  // a bus that never stops must not hold the caller
  userbus::FrameMessage message{};
  for (int i = 0; i < kMost && inbox_.next(socket_.get(), message) == FrameInbox::Outcome::Frame; ++i)
    static_cast<void>(note_link(message.trailer.flags));
  error_state_ = ErrorState::Active;
  return is_up();
}

/// What a message with @p flags tells of the bus; false if it is a frame.
bool UserBus::note_link(std::uint32_t flags) noexcept {
  if ((flags & (userbus::kLinkDown | userbus::kLinkUp)) == 0) return false;
  is_cut_ = (flags & userbus::kLinkDown) != 0;
  is_mended_ = !is_cut_;
  watch_link(is_cut_);
  if (is_mended_) entry_.ring();
  return true;
}

/// That the bus is whole again comes as a message, perhaps in one that was read already.
void UserBus::watch_link(bool watches) noexcept {
  for (const int descriptor : {socket_.get(), inbox_.descriptor()})
    if (watches)
      entry_.watch(descriptor);
    else
      entry_.watch_no_longer(descriptor);
}

SendStatus UserBus::send(const canopen::Frame& frame) noexcept {
  if (os::other_time == nullptr) {
    const can_frame wire = to_wire(frame);
    return send(&wire, sizeof wire);
  }
  userbus::FrameMessage message{.frame = to_wire(frame), .trailer = {}};
  message.trailer.time_ns = time_of_sending();
  return send(&message, sizeof message);
}

SendStatus UserBus::send_marked(const canopen::Frame& frame, const Mark& mark) noexcept {
  userbus::FrameMessage message{.frame = to_wire(frame), .trailer = {}};
  message.trailer.flags = mark.number << userbus::kOriginShift;
  message.trailer.origin = mark.hub;
  return send(&message, sizeof message);
}

SentMany UserBus::send_all(std::span<const canopen::Frame> frames) noexcept {
  if (!sends_together()) return Port::send_all(frames);
  std::array<userbus::FrameMessage, userbus::kMostFrames> messages{};
  const std::size_t most = std::min(messages.size(), entry_.most_frames());
  for (std::size_t sent = 0; sent < frames.size();) {
    const auto some = frames.subspan(sent, std::min(most, frames.size() - sent));
    std::ranges::transform(some, messages.begin(), [](const canopen::Frame& frame) {
      return userbus::FrameMessage{.frame = to_wire(frame), .trailer = {}};
    });
    messages[0].trailer.time_ns = time_of_sending();
    const SendStatus status = send(messages.data(), some.size() * sizeof messages[0]);
    if (status != SendStatus::Sent) return {sent, status};
    sent += some.size();
  }
  return {frames.size(), SendStatus::Sent};
}

SendStatus UserBus::send(const void* message, std::size_t size) noexcept {
  if (is_cut_) return SendStatus::Down;
  if (is_unapplied_ && is_member()) {
    apply();
    if (is_unapplied_) return SendStatus::Full;
  }
  if (::send(socket_.get(), message, size, MSG_DONTWAIT | MSG_NOSIGNAL) == static_cast<ssize_t>(size)) {
    if (os::other_time != nullptr) os::other_time->note_sent();
    return SendStatus::Sent;
  }
  // The socket of a hub that is gone polls readable, and receive() tells it.
  return means_no_hub(errno) ? SendStatus::Down : to_send_status(errno);
}

Received UserBus::receive(canopen::Frame& frame) noexcept {
  if (is_unapplied_ && is_member()) apply();
  for (int i = 0; i < kSkippedMessages; ++i) {
    userbus::FrameMessage message{};
    const FrameInbox::Outcome outcome = inbox_.next(socket_.get(), message);
    if (outcome == FrameInbox::Outcome::Gone) return hub_lost();
    if (outcome == FrameInbox::Outcome::Nothing) break;
    dropped_ = message.trailer.dropped;
    if (note_link(message.trailer.flags)) {
      if (is_cut_) return {Received::Down, std::exchange(error_state_, ErrorState::Active)};
      continue;
    }
    arrival_ = std::chrono::nanoseconds{message.trailer.time_ns};
    mark_ = {.hub = message.trailer.origin, .number = message.trailer.flags >> userbus::kOriginShift};
    if ((message.frame.can_id & CAN_ERR_FLAG) == 0) {
      frame = from_wire(message.frame);
      return {Received::Frame, error_state_};
    }
    const ErrorState before = std::exchange(error_state_, decode_error_state(message.frame, error_state_));
    if (error_state_ != before) return {Received::Error, error_state_};
  }
  return {Received::Nothing, error_state_};
}

Received UserBus::hub_lost() noexcept {
  error_state_ = ErrorState::Active;
  if (!is_member()) return {Received::Nothing, error_state_};  // told before
  pollable_.remove(socket_.get());
  watch_link(false);
  socket_ = os::Descriptor{};
  inbox_.clear();
  is_cut_ = false;
  is_mended_ = false;
  is_unapplied_ = false;  // the next one is told all
  dropped_before_ += std::exchange(dropped_, 0);
  entry_.try_later(/*first=*/true);
  return {Received::Down, error_state_};
}

std::optional<LinkState> UserBusLink::read() noexcept {
  return port_.try_again() ? std::optional{LinkState::Up} : std::nullopt;
}

}  // namespace bus
