#include "bus/connection.hpp"

#include <utility>

#include "bus/link_monitor.hpp"
#include "bus/socket_can.hpp"
#include "bus/socketcand_port.hpp"
#include "bus/udp_multicast.hpp"
#include "bus/user_bus.hpp"

namespace bus {

namespace {

Connection open_place(const KernelInterface& place) {
  // The watch begins first, so that no change falls between.
  auto link = std::make_unique<LinkMonitor>(place.name);
  return {std::make_unique<SocketCan>(place.name), std::move(link)};
}

Connection open_place(const UserBusPath& place) {
  auto port = std::make_unique<UserBus>(place.path);
  auto link = std::make_unique<UserBusLink>(*port);
  return {std::move(port), std::move(link)};
}

Connection open_place(const MulticastGroup& place) {
  auto port = std::make_unique<UdpMulticast>(place);
  auto link = std::make_unique<LinkMonitor>(port->interface());
  return {std::move(port), std::move(link)};
}

Connection open_place(const SocketcandServer& place) {
  auto port = std::make_unique<SocketcandPort>(place);
  auto link = std::make_unique<SocketcandLink>(*port);
  return {std::move(port), std::move(link)};
}

}  // namespace

Connection open(const Address& address) {
  return std::visit([](const auto& place) { return open_place(place); }, address.place);
}

}  // namespace bus
