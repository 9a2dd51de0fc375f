#include "bus/user_bus.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "bus/wire.hpp"
#include "userbus/request.hpp"

namespace bus {

namespace {

using userbus::Operation;

// Messages that change nothing are skipped; this many a call, so that a burst of them cannot hold the caller.
constexpr int kSkippedMessages = 16;

std::string hub_program() {
  if (const char* const named = std::getenv("CAN_HUB"); named != nullptr && *named != '\0') return named;
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).replace_filename("canhub");
}

/// A hub that closes leaves one of these errors in the sockets of its members.
bool means_no_hub(int error) noexcept {
  return error == EPIPE || error == ECONNRESET || error == ENOTCONN || error == EBADF;
}

}  // namespace

UserBus::UserBus(const std::string& path) : hub_{hub_program()} {
  if (!userbus::copy_path(path.c_str(), path_))
    throw OpenError{fmt::format("{}: expected a path of at most {} bytes", path, userbus::kLongestPath)};
  if (const userbus::JoinError error = join(); error != userbus::JoinError::None)
    throw OpenError{fmt::format("unix:{}: {}", path, userbus::text_of(error))};
}

userbus::JoinError UserBus::join() noexcept {
  const userbus::Joined joined =
      userbus::join(path_, hub_.c_str(), userbus::Kind::Port, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (joined.error != userbus::JoinError::None) return joined.error;
  socket_ = Descriptor{joined.descriptor};
  if (configure() && pollable_.add(socket_.get(), EPOLLIN)) return userbus::JoinError::None;
  const int reason = errno;
  socket_ = Descriptor{};
  errno = reason;
  return userbus::JoinError::System;
}

/// Bound last, so that nothing arrives that is not wanted. False with errno set.
bool UserBus::configure() noexcept {
  const userbus::Option errors{userbus::OptionName::ErrorFilter, kErrorMask};
  userbus::Answer answer =
      userbus::ask(socket_.get(), Operation::SetOption, 0, &errors, sizeof errors, nullptr, 0);
  if (answer.error == 0 && !apply_filters()) answer.error = errno;
  if (answer.error == 0)
    answer = userbus::ask(socket_.get(), Operation::InterfaceIndex, 0, kInterface.data(), kInterface.size(),
                          nullptr, 0);
  if (answer.error == 0) answer = userbus::ask(socket_.get(), Operation::Bind, answer.value);
  errno = answer.error;
  return answer.error == 0;
}

bool UserBus::apply_filters() noexcept {
  const auto filters = filters_.get();
  const userbus::Answer answer =
      userbus::ask(socket_.get(), Operation::SetFilters, 0, filters.data(), filters.size_bytes(), nullptr, 0);
  errno = answer.error;
  return answer.error == 0;
}

void UserBus::accept_only(std::span<const Filter> filters) noexcept {
  filters_.assign(filters);
  if (is_member()) apply_filters();  // a hub that does not answer is gone: receive() will tell
}

bool UserBus::try_again() noexcept {
  if (!retry_.take() || is_member()) return false;
  if (join() == userbus::JoinError::None) return true;
  retry_.start_later();
  return false;
}

bool UserBus::reopen() noexcept {
  constexpr int kMost = 1 << 20;  // a bus that never stops must not hold the caller
  userbus::FrameMessage message{};
  for (int i = 0; i<kMost&& ::recv(socket_.get(), &message, sizeof message, MSG_DONTWAIT)> 0; ++i) {
  }
  error_state_ = ErrorState::Active;
  return is_member();
}

SendStatus UserBus::send(const canopen::Frame& frame) noexcept {
  const can_frame wire = to_wire(frame);
  if (::send(socket_.get(), &wire, sizeof wire, MSG_DONTWAIT | MSG_NOSIGNAL) == sizeof wire)
    return SendStatus::Sent;
  // The socket of a hub that is gone polls readable, and receive() tells it.
  return means_no_hub(errno) ? SendStatus::Down : to_send_status(errno);
}

Received UserBus::receive(canopen::Frame& frame) noexcept {
  for (int i = 0; i < kSkippedMessages; ++i) {
    userbus::FrameMessage message{};
    const ssize_t size = ::recv(socket_.get(), &message, sizeof message, MSG_DONTWAIT);
    if (size == 0 || (size < 0 && means_no_hub(errno))) return hub_lost();
    if (size < 0) break;
    if (size != sizeof message) continue;
    dropped_ = message.trailer.dropped;
    arrival_ = std::chrono::nanoseconds{message.trailer.time_ns};
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
  socket_ = Descriptor{};
  dropped_before_ += std::exchange(dropped_, 0);
  retry_.start();
  return {Received::Down, error_state_};
}

std::optional<LinkState> UserBusLink::read() noexcept {
  return port_.try_again() ? std::optional{LinkState::Up} : std::nullopt;
}

}  // namespace bus
