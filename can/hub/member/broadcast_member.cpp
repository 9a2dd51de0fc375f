#include "can/hub/member/broadcast_member.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace hub {

BroadcastMember::BroadcastMember(Core& core, os::Descriptor socket)
    : Member{core, std::move(socket), userbus::Kind::BroadcastManager}, manager_{core.medium, *this} {}

int BroadcastMember::broadcast(std::span<const std::byte> message, int interface_index,
                               canopen::TimePoint now) noexcept {
  const int own = this->interface_index();
  if (own < 0) return ENOTCONN;
  const int error = manager_.request(message, own != 0 ? own : interface_index, now);
  if (error == 0) count_sent();
  return error;
}

void BroadcastMember::deliver(std::span<const std::byte> message, int interface_index) noexcept {
  userbus::Trailer trailer{};
  trailer.interface_index = interface_index;
  trailer.time_ns = core().clock.wall();
  trailer.dropped = dropped();
  std::byte room[userbus::kLongestMessage];
  std::ranges::copy(message, room);
  std::memcpy(&room[message.size()], &trailer, sizeof trailer);
  Member::deliver(std::span{room}.first(message.size() + sizeof trailer));
}

}  // namespace hub
