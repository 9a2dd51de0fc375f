#include "gateway/api/all_units.hpp"

#include <utility>

#include "control/error.hpp"
#include "gateway/api/gathering.hpp"
#include "gateway/base/json_text.hpp"
#include "gateway/base/overview_keys.hpp"
#include "os/clock.hpp"

namespace gateway {
namespace {

using nlohmann::json;

/// The members @p keys that @p object has.
template <class Keys>
json excerpt(const json& object, const Keys& keys) {
  json part = json::object();
  if (!object.is_object()) return part;
  for (const std::string_view key : keys)
    if (const auto found = object.find(key); found != object.end()) part[std::string{key}] = *found;
  return part;
}

}  // namespace

json overview_of(const std::string& unit, const Answer& status) {
  json told = status ? excerpt(*status, kOverviewKeys) : json::object();
  told["unit"] = unit;
  told["on"] = status.has_value();
  if (!status) {
    if (status.error().code != control::name_of(control::ErrorCode::Off)) told["error"] = status.error().message;
    return told;
  }
  for (const OverviewPart& part : kOverviewParts)
    if (const auto found = status->find(part.key); found != status->end())
      told[std::string{part.key}] = excerpt(*found, part.members);
  told["axes"] = json::array();
  for (const json& axis : status->value("axes", json::array()))
    told["axes"].push_back(excerpt(axis, kOverviewAxis));
  return told;
}

void AllUnits::answer(const std::shared_ptr<Exchange>& exchange) {
  if (shared_->text && os::monotonic_time() - shared_->since < kAge)
    return exchange->answer(Response{.shared_body = shared_->text});
  shared_->waiting.push_back(exchange);
  if (!std::exchange(shared_->is_asking, true)) ask();
}

void AllUnits::ask() const {
  const std::vector<std::string> names = daemons_.units();
  std::vector<std::string> hosts;
  hosts.reserve(names.size());
  for (const std::string& name : names) hosts.push_back(daemons_.host_of(name));
  const auto gathering =
      Gathering::make(names.size(), [shared = shared_, names, hosts](const Gathering::Answers& answers) {
        json units = json::array();
        for (std::size_t at = 0; at < names.size(); ++at) {
          json& unit = units.emplace_back(overview_of(names[at], answers[at]));
          if (!hosts[at].empty()) unit["host"] = hosts[at];
        }
        shared->text = std::make_shared<const std::string>(json_text({{"units", std::move(units)}}) + '\n');
        shared->since = os::monotonic_time();
        shared->is_asking = false;
        for (const std::shared_ptr<Exchange>& exchange : std::exchange(shared->waiting, {}))
          exchange->answer(Response{.shared_body = shared->text});
      });
  for (const std::string& name : names)
    daemons_.find(name).value()->ask("status", {{"unit", name}}, gathering->place());
}

}  // namespace gateway
