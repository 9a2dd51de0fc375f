#include "can/nats/bus.hpp"

#include <utility>

#include "can/nats/url.hpp"

namespace nats {

tl::expected<Bus, std::string> parse_bus(std::string_view url) {
  return parse_url(url, "NAME").map([](Url read) {
    Bus bus;
    bus.server = std::move(read.server);
    bus.host = std::move(read.host);
    bus.port = std::move(read.port);
    bus.name = std::move(read.name);
    return bus;
  });
}

}  // namespace nats
