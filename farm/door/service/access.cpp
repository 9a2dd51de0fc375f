#include "farm/door/service/access.hpp"

#include <algorithm>

#include "gateway/routes/routes.hpp"

namespace farm {

namespace {

constexpr std::string_view kBegin = ".subscribe";
constexpr std::string_view kEnd = ".unsubscribe";

}  // namespace

bool begins_subscription(std::string_view method) noexcept {
  return method.ends_with(kBegin);
}

bool is_subscription(std::string_view method) noexcept {
  return begins_subscription(method) || method.ends_with(kEnd);
}

bool is_read(std::string_view method, const nlohmann::json& params) {
  if (is_subscription(method)) return true;
  return std::ranges::any_of(gateway::routes(), [&](const gateway::Route& route) {
    return !route.is_write() && route.method == method &&
           (route.without.empty() || !params.contains(std::string{route.without}));
  });
}

}  // namespace farm
