#include "can/port/socketcan/socket_can.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <linux/can/raw.h>
#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "can/port/socket_option.hpp"
#include "can/port/socketcan/controller.hpp"
#include "can/port/wire.hpp"

namespace bus {

namespace {

// Error frames that change nothing are skipped; this many a call, so that a burst of them cannot hold the caller.
constexpr int kSkippedFrames = 16;

os::Descriptor open_socket() {
  os::Descriptor socket{::socket(AF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW)};
  if (socket) return socket;
  const std::string reason = std::generic_category().message(errno);
  if (errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT)
    throw OpenError{fmt::format("kernel has no CAN (socket(AF_CAN): {})", reason)};
  throw OpenError{fmt::format("socket(AF_CAN): {}", reason)};
}

/// Takes the error that a lost link leaves in its socket: the next frame sent would fail with it and be lost.
void take_pending_error(const os::Descriptor& socket) noexcept {
  int error = 0;
  socklen_t length = sizeof error;
  ::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &length);
}

}  // namespace

SocketCan::SocketCan(std::string interface, int receive_buffer)
    : interface_{std::move(interface)}, wanted_buffer_{receive_buffer}, socket_{open_socket()} {
  configure();
  const auto index = can_interface_index(interface_, socket_);
  if (!index) throw OpenError{index.error()};
  if (!bind_to(*index))
    throw OpenError{fmt::format("{}: bind: {}", interface_, std::generic_category().message(errno))};
}

void SocketCan::configure() {
  const bool configured = set_option(socket_, SOL_CAN_RAW, CAN_RAW_LOOPBACK, int{1}) &&
                          set_option(socket_, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, int{0}) &&
                          set_option(socket_, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kErrorMask);
  static_cast<void>(frame_arrival());  // the kernel stamps frames once it has been asked
  if (!configured)
    throw OpenError{fmt::format("{}: setsockopt: {}", interface_, std::generic_category().message(errno))};
  ask_for_receive_buffer(socket_, wanted_buffer_);
}

bool SocketCan::bind_to(int index) noexcept {
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = index;
  // sockaddr is the common form of all socket addresses.
  return ::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool SocketCan::reopen() noexcept {
  const auto index = can_interface_index(interface_, socket_);
  if (!index || !bind_to(*index)) return false;
  apply_filters();  // the kernel forgets them with the interface
  take_pending_error(socket_);
  discard_received();
  error_state_ = ErrorState::Active;
  link_failure_ = LinkFailure::None;
  return true;
}

Restart SocketCan::restart() noexcept {
  const auto index = can_interface_index(interface_, socket_);
  const Restart outcome = index ? restart_controller(*index) : Restart::Started;
  if (outcome == Restart::Done) error_state_ = ErrorState::Active;  // nobody else tells
  return outcome;
}

/// What waited while the link was away is no longer meant for anybody.
void SocketCan::discard_received() noexcept {
  constexpr int kMost = 1 << 20;  // a bus that never stops must not hold the caller
  can_frame wire{};
  for (int i = 0; i < kMost && take(wire) >= 0; ++i) {
  }
}

std::optional<ReceiveBuffer> SocketCan::receive_buffer() const noexcept {
  return receive_buffer_of(socket_, wanted_buffer_);
}

/// Asked for when somebody wants to know: a control message with every frame would cost each of them.
std::uint64_t SocketCan::dropped() const noexcept {
  return lost_messages(socket_);
}

void SocketCan::accept_only(std::span<const Filter> filters) noexcept {
  filters_.assign(filters);
  apply_filters();
}

void SocketCan::apply_filters() noexcept {
  const auto filters = filters_.get();
  const auto size = static_cast<socklen_t>(filters.size_bytes());
  if (::setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(), size) == 0) return;
  // Too many frames are harmless, too few are not.
  set_option(socket_, SOL_CAN_RAW, CAN_RAW_FILTER, can_filter{0, 0});
}

std::optional<std::chrono::nanoseconds> SocketCan::frame_arrival() const noexcept {
  timespec stamp{};
  if (::ioctl(socket_.get(), SIOCGSTAMPNS, &stamp) != 0) return std::nullopt;
  return std::chrono::seconds{stamp.tv_sec} + std::chrono::nanoseconds{stamp.tv_nsec};
}

SendStatus SocketCan::send(const canopen::Frame& frame) noexcept {
  const can_frame wire = to_wire(frame);
  if (::send(socket_.get(), &wire, sizeof wire, MSG_DONTWAIT) == sizeof wire) {
    link_failure_ = LinkFailure::None;
    return SendStatus::Sent;
  }
  const SendStatus status = to_send_status(errno);
  if (status == SendStatus::Down && link_failure_ == LinkFailure::None) link_failure_ = LinkFailure::Untold;
  return status;
}

Received SocketCan::receive(canopen::Frame& frame) noexcept {
  // A failing send takes the socket's pending error away, so that recv would never show it.
  if (link_failure_ == LinkFailure::Untold) return failed(ENETDOWN);
  for (int i = 0; i < kSkippedFrames; ++i) {
    can_frame wire{};
    if (take(wire) < 0) return failed(errno);
    if (const Received received = tell(wire, frame); received.kind != Received::Nothing) return received;
  }
  return {Received::Nothing, error_state_};
}

/// What @p wire tells; error frames may change nothing.
Received SocketCan::tell(const can_frame& wire, canopen::Frame& frame) noexcept {
  if ((wire.can_id & CAN_ERR_FLAG) == 0) {
    frame = from_wire(wire);
    return {Received::Frame, error_state_};
  }
  const ErrorState before = std::exchange(error_state_, decode_error_state(wire, error_state_));
  return {error_state_ != before ? Received::Error : Received::Nothing, error_state_};
}

std::size_t SocketCan::receive_all(std::span<Arrival> arrivals) noexcept {
  if (arrivals.empty()) return 0;
  if (link_failure_ == LinkFailure::Untold) {
    arrivals[0].received = failed(ENETDOWN);
    return 1;
  }
  constexpr std::size_t kMost = 64;
  std::array<can_frame, kMost> wires;
  std::array<iovec, kMost> parts;
  std::array<mmsghdr, kMost> headers{};
  const std::size_t room = std::min(arrivals.size(), kMost);
  for (std::size_t i = 0; i < room; ++i) {
    parts[i] = {&wires[i], sizeof wires[i]};
    headers[i].msg_hdr.msg_iov = &parts[i];
    headers[i].msg_hdr.msg_iovlen = 1;
  }
  const int frames = ::recvmmsg(socket_.get(), headers.data(), static_cast<unsigned>(room), MSG_DONTWAIT, nullptr);
  if (frames < 0) {
    arrivals[0].received = failed(errno);
    return arrivals[0].received.kind == Received::Nothing ? 0 : 1;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
    Arrival& arrival = arrivals[count];
    arrival.received = tell(wires[i], arrival.frame);
    if (arrival.received.kind != Received::Nothing) ++count;
  }
  return count;
}

/// recv takes fewer instructions than read, and far fewer than recvmsg.
ssize_t SocketCan::take(can_frame& wire) noexcept {
  return ::recv(socket_.get(), &wire, sizeof wire, MSG_DONTWAIT);
}

Received SocketCan::failed(int error) noexcept {
  if (to_send_status(error) != SendStatus::Down) return {Received::Nothing, error_state_};
  link_failure_ = LinkFailure::Told;
  error_state_ = ErrorState::Active;  // the controller starts anew when the link comes up
  return {Received::Down, error_state_};
}

}  // namespace bus
