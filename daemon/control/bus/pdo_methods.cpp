// The PDOs of the unit.
#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "daemon/control/arguments.hpp"
#include "daemon/control/bus/pdo_view.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/control/place.hpp"

namespace axisd {
namespace {

using PdoDirection = canopen::Direction;
using nlohmann::json;

constexpr std::array<std::string_view, 3> kDirections{"both", "receive", "transmit"};
enum Directions : std::size_t { kBoth, kReceive, kTransmit };

/// A line has room for all that are valid.
constexpr std::int64_t kMostEntries = 48;
constexpr std::int64_t kLastPlace = 1000;

/// Begins or ends to count frames, as key "watch" says.
Taken<void> follow_watch(const Call& call, const json& params) {
  PdoWatch& watch = call.instance.pdo_watch();
  const auto wanted = Arguments{params}.flag("watch", watch.is_on());
  if (!wanted) return tl::unexpected{wanted.error()};
  if (!*wanted) {
    watch.end();
  } else if (!watch.begin(call.now)) {
    return refuse(control::ErrorCode::Overflow, "watch: too many listen to the frames of the unit");
  }
  return {};
}

/// What of the PDOs is wanted.
struct Wanted {
  std::size_t axis;  ///< 0: of all
  std::size_t direction;
  bool all;  ///< those too that are not valid
  Page page;
};

Taken<Wanted> wanted_of(const Call& call, const json& params) {
  const Arguments arguments{params};
  const auto axes = static_cast<std::int64_t>(call.instance.device().unit().axes().size());
  const auto axis = arguments.integer("axis", 1, axes, 0);
  if (!axis) return tl::unexpected{axis.error()};
  const auto direction = arguments.choice("direction", kDirections, kBoth);
  if (!direction) return tl::unexpected{direction.error()};
  const auto all = arguments.flag("all", false);
  if (!all) return tl::unexpected{all.error()};
  const auto page = arguments.page({.last = kLastPlace, .most = kMostEntries, .usual = kMostEntries});
  if (!page) return tl::unexpected{page.error()};
  return Wanted{static_cast<std::size_t>(*axis), *direction, *all, *page};
}

/// The PDOs that are wanted, RPDOs first.
struct Chosen {
  const canopen::PdoSettings* settings;
  PdoDirection direction;
};
std::vector<Chosen> chosen_of(const canopen::Node& node, const Wanted& wanted) {
  std::vector<Chosen> chosen;
  const auto choose = [&](std::span<const canopen::PdoSettings> pdos, PdoDirection direction) {
    for (const canopen::PdoSettings& settings : pdos) {
      const std::size_t axis = device::pdo::Pdo{direction, settings.number}.axis();
      if ((wanted.axis == 0 || wanted.axis == axis) && (wanted.all || settings.is_valid()))
        chosen.push_back({&settings, direction});
    }
  };
  if (wanted.direction != kTransmit) choose(node.receive_pdos(), PdoDirection::Receive);
  if (wanted.direction != kReceive) choose(node.transmit_pdos(), PdoDirection::Transmit);
  return chosen;
}

Outcome list_pdos(const Call& call, const json& params) {
  const auto wanted = wanted_of(call, params);
  if (!wanted) return tl::unexpected{wanted.error()};
  if (const auto followed = follow_watch(call, params); !followed) return tl::unexpected{followed.error()};
  const std::vector<Chosen> chosen = chosen_of(call.instance.device().node(), *wanted);
  const std::size_t end = std::min(chosen.size(), wanted->page.from + wanted->page.count);
  json list = json::array();
  for (std::size_t at = wanted->page.from; at < end; ++at)
    list.push_back(pdo_json(call.instance, *chosen[at].settings, chosen[at].direction, call.now));
  const PdoWatch& watch = call.instance.pdo_watch();
  json result{{"pdos", std::move(list)}, {"total", chosen.size()}, {"is_watched", watch.is_on()}};
  if (watch.is_on()) result["watched_s"] = std::chrono::duration<double>{call.now - watch.since()}.count();
  if (end < chosen.size()) result["next"] = end;
  return result;
}

constexpr std::array kPdoHandlers{
    Handler{"pdo.list", &list_pdos},
};

}  // namespace

std::span<const Handler> pdo_handlers() noexcept {
  return kPdoHandlers;
}

}  // namespace axisd
