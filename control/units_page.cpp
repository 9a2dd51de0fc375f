#include "control/units_page.hpp"

#include <utility>

#include "control/protocol.hpp"

namespace control {
namespace {

/// Bytes of a line that are left to what is no unit.
constexpr std::size_t kOthers = 1024;

}  // namespace

nlohmann::json units_page(std::size_t from, std::size_t count,
                          const std::function<nlohmann::json(std::size_t)>& entry) {
  nlohmann::json units = nlohmann::json::array();
  std::size_t size = kOthers;
  std::size_t at = from;
  for (; at < count; ++at) {
    nlohmann::json unit = entry(at);
    size += unit.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).size() + 1;
    if (size > kMaximumLine) break;
    units.push_back(std::move(unit));
  }
  nlohmann::json page{{"units", std::move(units)}};
  if (at < count) page["next"] = at;
  return page;
}

}  // namespace control
