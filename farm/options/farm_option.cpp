#include "farm/options/farm_option.hpp"

#include <fmt/format.h>

namespace farm {

tl::expected<FarmUrl, std::string> read_farm(std::string_view url, const nats::ServerOptions& server,
                                             std::string_view name) {
  auto farm = parse_farm_url(url);
  if (!farm) return tl::unexpected{fmt::format("{}: {}, got \"{}\"", name, farm.error(), url)};
  if (auto secured = nats::secure(farm->server, farm->host, server, name); !secured)
    return tl::unexpected{std::move(secured.error())};
  return farm;
}

}  // namespace farm
