#include "can/nats/url.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "text/name.hpp"
#include "text/number.hpp"

namespace nats {

namespace {

constexpr std::string_view kUsualPort = "4222";

tl::unexpected<std::string> expected(std::string_view what) {
  return tl::unexpected{fmt::format("expected {}", what)};
}

std::string form_of(std::string_view what) {
  const std::string end = what.empty() ? "" : fmt::format("/{}", what);
  return fmt::format("nats://HOST[:PORT]{} or tls://HOST[:PORT]{}", end, end);
}

/// Reads "HOST[:PORT]"; @p form is what the whole should be.
tl::expected<Url, std::string> parse_place(std::string_view scheme, std::string_view place,
                                           std::string_view form) {
  if (place.find('@') != std::string_view::npos) return expected("no user in the URL: --credentials names a file");
  const bool in_brackets = place.starts_with('[');
  const std::size_t end_of_host = in_brackets ? place.find(']') + 1 : std::min(place.find(':'), place.size());
  if (in_brackets && end_of_host == 0) return expected("a ] behind the host");
  const std::string_view rest = place.substr(end_of_host);
  const std::string_view port = rest.empty() ? kUsualPort : rest.substr(1);
  const auto number = text::integer<std::uint16_t>(port);
  if ((!rest.empty() && rest[0] != ':') || !number || *number == 0)
    return expected("a port 1 to 65535 behind the host");
  const std::string_view host = in_brackets ? place.substr(1, end_of_host - 2) : place.substr(0, end_of_host);
  if (host.empty()) return expected(form);
  Url url;
  url.server.url = fmt::format("{}://{}:{}", scheme, place.substr(0, end_of_host), port);
  url.host = host;
  url.port = port;
  return url;
}

}  // namespace

bool is_url(std::string_view text) noexcept {
  return text.starts_with("nats://") || text.starts_with("tls://");
}

tl::expected<Url, std::string> parse_url(std::string_view whole, std::string_view what) {
  const std::string form = form_of(what);
  if (!is_url(whole)) return expected(form);
  const std::size_t host_at = whole.find("://") + 3;
  const std::size_t slash = whole.find('/', host_at);
  const bool has_name = slash != std::string_view::npos;
  if (has_name == what.empty()) return expected(form);
  const std::string_view name = has_name ? whole.substr(slash + 1) : std::string_view{};
  if (has_name && !text::is_name(name))
    return expected(fmt::format("a name of {} behind the slash", text::kNameForm));
  const std::size_t length = has_name ? slash - host_at : std::string_view::npos;
  auto url = parse_place(whole.substr(0, host_at - 3), whole.substr(host_at, length), form);
  if (url) url->name = name;
  return url;
}

}  // namespace nats
