#include "can/connection/connection.hpp"

#include <utility>

#include "can/port/multicast/udp_multicast.hpp"
#include "can/port/socketcan/link_monitor.hpp"
#include "can/port/socketcan/socket_can.hpp"
#include "can/port/socketcand/socketcand_port.hpp"
#include "can/port/user_bus/user_bus.hpp"

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
