#include "farm/naming/farm_url.hpp"

#include <utility>

#include "can/nats/bus.hpp"

namespace farm {

tl::expected<FarmUrl, std::string> parse_farm_url(std::string_view text) {
  return nats::parse_bus(text).map([](nats::Bus bus) {
    return FarmUrl{std::move(bus.server), std::move(bus.host), std::move(bus.name)};
  });
}

}  // namespace farm
