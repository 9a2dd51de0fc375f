#include "can/hub/trunk/report.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "can/hub/trunk/trunk.hpp"

namespace hub::trunk {

namespace {

std::int64_t median(const Latency& latency) noexcept {
  constexpr double kHalf = 0.5;
  return latency.quantile(kHalf).count();
}
std::int64_t nearly_all(const Latency& latency) noexcept {
  constexpr double kNearlyAll = 0.99;
  return latency.quantile(kNearlyAll).count();
}

}  // namespace

std::string report_of(const Trunk& trunk, std::uint64_t lost, std::size_t room) {
  const Figures& figures = trunk.figures();
  const Hubs& hubs = trunk.hubs();
  nlohmann::json whole = {
      {"url", trunk.settings().url},
      {"up", trunk.is_up()},
      {"sent", figures.sent},
      {"received", figures.received},
      {"under_way", trunk.under_way()},
      {"dropped", figures.dropped},
      {"lost", lost},
      {"missed", hubs.missed()},
      {"late", figures.stale},
      {"repeated", hubs.repeated() + figures.repeated},
      {"malformed", figures.malformed},
      {"cuts", figures.cuts},
      {"back_after_ns", {{"median", median(trunk.latency())}, {"p99", nearly_all(trunk.latency())}}},
      {"hubs", nlohmann::json::array()},
  };
  for (const Neighbour& hub : hubs.all()) {
    if (hub.hub == 0) continue;
    nlohmann::json row = {
        {"name", hub.text()}, {"present", hub.is_present}, {"received", hub.received}, {"missed", hub.missed}};
    whole["hubs"].push_back(std::move(row));
    if (whole.dump().size() <= room) continue;
    whole["hubs"].erase(whole["hubs"].size() - 1);
    break;
  }
  return whole.dump();
}

}  // namespace hub::trunk
