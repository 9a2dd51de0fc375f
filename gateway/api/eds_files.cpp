#include "gateway/api/eds_files.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "control/eds_file.hpp"
#include "gateway/units/unit_list.hpp"
#include "os/regular_file.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::size_t kLargest = 4UL * 1024 * 1024;

/// What @p units, the answer of its daemon, says of @p unit; without axes: it is not there.
UnitKind kind_of(const json& units, const std::string& unit) {
  const json list = units.value("units", json::array());
  const auto found = std::ranges::find_if(
      list, [&unit](const json& each) { return each.is_object() && each.value("unit", "") == unit; });
  if (found == list.end()) return {};
  return {.profile = found->value("profile", std::string{control::kProfileS120}),
          .axes = found->value("axes", std::size_t{0})};
}

}  // namespace

Response EdsFiles::response_for(const UnitKind& kind) {
  const std::string name = control::eds_file_name(kind.profile, kind.axes);
  const auto known = texts_.find(name);
  if (known != texts_.end())
    return {.content_type = "text/plain; charset=utf-8",
            .headers = {{"Content-Disposition", fmt::format("inline; filename=\"{}\"", name)}},
            .shared_body = known->second};
  auto text = os::read_regular_file((folder_ / name).string(), kLargest);
  if (!text)
    return response_of(
        refuse(Refused::NoSuchPath,
               fmt::format("no EDS of a unit of profile {} with {} axes is installed beside the gateway",
                           kind.profile, kind.axes)));
  texts_.emplace(name, std::make_shared<const std::string>(*std::move(text)));
  return response_for(kind);
}

void EdsFiles::answer(const std::shared_ptr<Exchange>& exchange, const std::string& unit, DaemonClient& daemon) {
  ask_for_units(daemon, [this, exchange, unit](const Answer& units) {
    exchange->answer(units ? response_for(kind_of(*units, unit)) : response_of(units.error()));
  });
}

}  // namespace gateway
