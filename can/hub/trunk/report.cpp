#include "can/hub/trunk/report.hpp"

#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "can/hub/trunk/trunk.hpp"

namespace hub::trunk {

namespace {

using nlohmann::json;

json quantiles(const Latency& latency) {
  constexpr double kHalf = 0.5;
  constexpr double kNearlyAll = 0.99;
  return {{"median", latency.quantile(kHalf).count()}, {"p99", latency.quantile(kNearlyAll).count()}};
}

std::uint64_t malformed(const Trunk& trunk) noexcept {
  const Arbitration* const arbitration = trunk.arbitration();
  return trunk.figures().malformed + (arbitration != nullptr ? arbitration->malformed() : 0);
}

/// Who decides which frame is next; null without a bit rate.
json arbitration_of(const Trunk& trunk) {
  const Arbitration* const arbitration = trunk.arbitration();
  if (arbitration == nullptr) return nullptr;
  std::string_view arbiter;
  if (arbitration->is_arbiter()) arbiter = trunk.settings().name;
  for (const Neighbour& hub : trunk.hubs().all())
    if (hub.hub != 0 && hub.hub == arbitration->arbiter()) arbiter = hub.text();
  return {{"bit_rate", trunk.settings().bit_rate},
          {"arbiter", arbiter},
          {"is_here", arbitration->is_arbiter()},
          {"term", arbitration->term()},
          {"waiting", arbitration->waiting()}};
}

/// Names are what other hubs say.
std::string text_of(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json row_of(const Neighbour& hub) {
  return {{"name", hub.text()}, {"present", hub.is_present}, {"received", hub.received}, {"missed", hub.missed}};
}

}  // namespace

std::string report_of(const Trunk& trunk, std::uint64_t lost, std::size_t room) {
  const Figures& figures = trunk.figures();
  json whole = {
      {"url", trunk.settings().url},
      {"up", trunk.is_up()},
      {"sent", figures.sent},
      {"received", figures.received},
      {"under_way", trunk.under_way()},
      {"dropped", figures.dropped},
      {"lost", lost},
      {"missed", trunk.hubs().missed()},
      {"late", figures.stale},
      {"repeated", trunk.hubs().repeated() + figures.repeated},
      {"malformed", malformed(trunk)},
      {"cuts", figures.cuts},
      {"back_after_ns", quantiles(trunk.latency())},
      {"arbitration", arbitration_of(trunk)},
      {"hubs", json::array()},
  };
  for (const Neighbour& hub : trunk.hubs().all()) {
    if (hub.hub == 0) continue;
    whole["hubs"].push_back(row_of(hub));
    if (text_of(whole).size() <= room) continue;
    whole["hubs"].erase(whole["hubs"].size() - 1);
    break;
  }
  return text_of(whole);
}

std::string text_of_bit_rate(std::uint32_t bit_rate) {
  return bit_rate == 0 ? "without a bit rate" : fmt::format("at {} bit/s", bit_rate);
}

userbus::MemberStatistics row_of(const Trunk& trunk) noexcept {
  userbus::MemberStatistics row{};
  const Figures& figures = trunk.figures();
  trunk.settings().url.copy(row.name, sizeof row.name - 1);
  row.sent = figures.received;
  row.received = figures.sent;
  row.dropped = figures.dropped + trunk.hubs().missed();
  row.refused = malformed(trunk);
  return row;
}

}  // namespace hub::trunk
