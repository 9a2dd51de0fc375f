#include "bus/connection.hpp"

#include "bus/link_monitor.hpp"
#include "bus/socket_can.hpp"

namespace bus {

namespace {

Connection open_place(const KernelInterface& place) {
  // The watch begins first, so that no change falls between.
  auto link = std::make_unique<LinkMonitor>(place.name);
  return {std::make_unique<SocketCan>(place.name), std::move(link)};
}

}  // namespace

Connection open(const Address& address) {
  return open_place(std::get<KernelInterface>(address.place));
}

}  // namespace bus
