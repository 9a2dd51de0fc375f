#include "can/nats/bus.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "text/name.hpp"
#include "text/number.hpp"

namespace nats {

namespace {

constexpr std::string_view kForm = "nats://HOST[:PORT]/NAME or tls://HOST[:PORT]/NAME";
constexpr std::string_view kUsualPort = "4222";

}  // namespace

tl::expected<Bus, std::string> parse_bus(std::string_view url) {
  const auto wrong = [](std::string_view expected) {
    return tl::unexpected{fmt::format("expected {}", expected)};
  };
  const std::size_t host_at = url.find("://") + 3;
  const std::string_view scheme = url.substr(0, url.find("://"));
  if (host_at < 3 || (scheme != "nats" && scheme != "tls")) return wrong(kForm);
  const std::size_t slash = url.find('/', host_at);
  if (slash == std::string_view::npos) return wrong(kForm);
  const std::string_view place = url.substr(host_at, slash - host_at);
  const std::string_view name = url.substr(slash + 1);
  if (!text::is_name(name)) return wrong(fmt::format("a name of {} behind the slash", text::kNameForm));
  if (place.find('@') != std::string_view::npos) return wrong("no user in the URL: --credentials names a file");
  const bool in_brackets = place.starts_with('[');
  const std::size_t end_of_host = in_brackets ? place.find(']') + 1 : std::min(place.find(':'), place.size());
  if (in_brackets && end_of_host == 0) return wrong("a ] behind the host");
  const std::string_view rest = place.substr(end_of_host);
  const std::string_view port = rest.empty() ? kUsualPort : rest.substr(1);
  const auto number = text::integer<std::uint16_t>(port);
  if ((!rest.empty() && rest[0] != ':') || !number || *number == 0)
    return wrong("a port 1 to 65535 behind the host");
  const std::string_view host = in_brackets ? place.substr(1, end_of_host - 2) : place.substr(0, end_of_host);
  if (host.empty()) return wrong(kForm);
  Bus bus;
  bus.server.url = fmt::format("{}://{}:{}", scheme, place.substr(0, end_of_host), port);
  bus.host = host;
  bus.port = port;
  bus.name = name;
  return bus;
}

}  // namespace nats
