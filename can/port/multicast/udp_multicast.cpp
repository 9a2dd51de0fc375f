#include "can/port/multicast/udp_multicast.hpp"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>

#include "can/port/interface.hpp"
#include "can/port/multicast/multicast_message.hpp"
#include "can/port/multicast/route.hpp"
#include "can/port/socket_option.hpp"
#include "can/port/wire.hpp"

namespace bus {

namespace {

// Datagrams that are of no account are skipped; this many a call, so that a burst of them cannot hold the caller.
constexpr int kSkippedDatagrams = 16;

std::string reason() {
  return std::generic_category().message(errno);
}

/// The interface to use; throws OpenError.
std::string choose_interface(const MulticastGroup& place) {
  std::string name =
      place.interface.empty() ? interface_towards(multicast::address_of(place, 0)) : place.interface;
  if (name.empty())
    throw OpenError{
        fmt::format("{}: no route to the multicast group ({}): add a route or name the interface (?interface=lo)",
                    place.group, reason())};
  if (query(name) == LinkState::Gone) throw OpenError{fmt::format("{}: no such network interface", name)};
  return name;
}

}  // namespace

UdpMulticast::UdpMulticast(MulticastGroup place) : place_{std::move(place)}, interface_{choose_interface(place_)} {
  if (query(interface_) == LinkState::Up && !reopen())
    throw OpenError{fmt::format("{} on {}: {}", place_.group, interface_, reason())};
}

bool UdpMulticast::reopen() noexcept {
  sockets_ = {};  // first, so that the new ones are not told from them
  error_state_ = ErrorState::Active;
  sockets_ = multicast::open_sockets(place_, interface_, kReceiveBuffer);
  return sockets_.receiver && pollable_.add(sockets_.receiver.get(), EPOLLIN);
}

SendStatus UdpMulticast::send(const canopen::Frame& frame) noexcept {
  try {
    const auto datagram = multicast::pack(to_wire(frame));
    if (::send(sockets_.sender.get(), datagram.data(), datagram.size(), MSG_DONTWAIT) >= 0)
      return SendStatus::Sent;
  } catch (const std::bad_alloc&) {
    return SendStatus::Failed;
  }
  return to_send_status(errno);
}

Received UdpMulticast::receive(canopen::Frame& frame) noexcept {
  std::array<std::uint8_t, multicast::kLongestDatagram> datagram{};
  for (int i = 0; i < kSkippedDatagrams; ++i) {
    SocketAddress source;
    // MSG_TRUNC: the length of the datagram, also where the buffer is too small for it
    const ssize_t size = ::recvfrom(sockets_.receiver.get(), datagram.data(), datagram.size(),
                                    MSG_DONTWAIT | MSG_TRUNC, source.get(), &source.length);
    if (size < 0) break;
    if (multicast::same(source, sockets_.source)) continue;
    const auto length = static_cast<std::size_t>(size);
    const auto wire =
        length <= datagram.size() ? multicast::unpack(std::span{datagram}.first(length)) : std::nullopt;
    if (!wire) {
      ++rejected_;
    } else if ((wire->can_id & CAN_ERR_FLAG) != 0) {
      const ErrorState before = std::exchange(error_state_, decode_error_state(*wire, error_state_));
      if (error_state_ != before) return {Received::Error, error_state_};
    } else if (const canopen::Frame received = from_wire(*wire); filters_.pass(received)) {
      frame = received;
      return {Received::Frame, error_state_};
    }
  }
  return {Received::Nothing, error_state_};
}

std::uint64_t UdpMulticast::dropped() const noexcept {
  return rejected_ + lost_messages(sockets_.receiver);
}

std::optional<ReceiveBuffer> UdpMulticast::receive_buffer() const noexcept {
  return receive_buffer_of(sockets_.receiver, kReceiveBuffer);
}

}  // namespace bus
