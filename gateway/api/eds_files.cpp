#include "gateway/api/eds_files.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "os/regular_file.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::size_t kLargest = 4UL * 1024 * 1024;

/// The axes of @p unit in @p units, the answer of its daemon; 0: it is not there.
std::size_t axes_of(const json& units, const std::string& unit) {
  const json list = units.value("units", json::array());
  const auto found = std::ranges::find_if(
      list, [&unit](const json& each) { return each.is_object() && each.value("unit", "") == unit; });
  return found == list.end() ? 0 : found->value("axes", std::size_t{0});
}

std::string name_of(std::size_t axes) {
  return axes == 1 ? "axisd.eds" : fmt::format("axisd-{}-axes.eds", axes);
}

}  // namespace

Response EdsFiles::response_for(std::size_t axes) {
  const auto known = texts_.find(axes);
  if (known != texts_.end())
    return {.content_type = "text/plain; charset=utf-8",
            .headers = {{"Content-Disposition", fmt::format("inline; filename=\"{}\"", name_of(axes))}},
            .shared_body = known->second};
  auto text = os::read_regular_file((folder_ / name_of(axes)).string(), kLargest);
  if (!text)
    return response_of(refuse(Refused::NoSuchPath,
                              fmt::format("no EDS of a unit with {} axes is installed beside the gateway", axes)));
  texts_.emplace(axes, std::make_shared<const std::string>(*std::move(text)));
  return response_for(axes);
}

void EdsFiles::answer(const std::shared_ptr<Exchange>& exchange, const std::string& unit, DaemonClient& daemon) {
  daemon.ask("units", json::object(), [this, exchange, unit](const Answer& units) {
    exchange->answer(units ? response_for(axes_of(*units, unit)) : response_of(units.error()));
  });
}

}  // namespace gateway
