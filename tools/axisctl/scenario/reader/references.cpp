#include "tools/axisctl/scenario/reader/references.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/methods.hpp"
#include "control/request_check.hpp"
#include "json/strict.hpp"
#include "tools/axisctl/scenario/language/check.hpp"
#include "tools/axisctl/scenario/language/fault_kinds.hpp"

namespace scenario {
namespace {

using nlohmann::json;
using Complaint = std::optional<std::string>;
using Names = std::set<std::string>;

constexpr std::size_t kMostAxes = 8;

Complaint expect_in(const Names& names, const json& name, const std::string& path, std::string_view what) {
  if (names.contains(name.get<std::string>())) return std::nullopt;
  if (names.empty()) return fmt::format("{}: expected {}, there is none", path, what);
  return fmt::format("{}: expected {}: {}; got {}", path, what, fmt::join(names, ", "), json_text::quote(name));
}

/// The names in the list @p key of @p scenario; each may be there once.
Complaint collect(const json& scenario, const char* key, Names& names) {
  const json list = scenario.value(key, json::array());
  for (std::size_t i = 0; i < list.size(); ++i)
    if (const auto name = list[i].find("name"); name != list[i].end() && !names.insert(*name).second)
      return fmt::format("/{}/{}/name: expected a name of its own, got {}", key, i, json_text::quote(*name));
  return std::nullopt;
}

/// Looks the names of the steps up, in their order.
class StepNames {
 public:
  explicit StepNames(const json& scenario) : scenario_{scenario} {}

  Complaint check() {
    for (const auto& [key, names] : {std::pair{"units", &units_}, {"programs", &programs_}, {"steps", &steps_}})
      if (Complaint complaint = collect(scenario_, key, *names)) return complaint;
    const json& steps = scenario_.at("steps");
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (Complaint complaint = check_step(steps[i], fmt::format("/steps/{}", i))) return complaint;
    return std::nullopt;
  }

 private:
  Complaint check_step(const json& step, const std::string& path) {
    const Alternative& action = *alternative_of(step, actions());
    if (Complaint complaint = check_unit(step, action, path)) return complaint;
    for (const char* const key : {"on", "expect", "never", "always"})
      if (const auto condition = step.find(key); condition != step.end())
        if (Complaint complaint = check_condition(*condition, path + "/" + key)) return complaint;
    if (step.contains("until"))
      if (Complaint complaint = check_until(step, path)) return complaint;
    if (const auto method = step.find("call"); method != step.end())
      if (Complaint complaint = check_call(*method, step.value("params", json::object()), path)) return complaint;
    return check_owner(step, action.key.key, path);
  }

  /// Faults, cyclic frames and programs, which have to be there before they are named.
  Complaint check_owner(const json& step, std::string_view action, const std::string& path) {
    const std::string place = fmt::format("{}/{}", path, action);
    const json& value = step.at(std::string{action});
    if (action == "cyclic") senders_.insert(step.at("as").get<std::string>());
    if (action == "stop") return expect_in(senders_, value, place, "the name of a cyclic frame before");
    if (action == "remove")
      return expect_in(faults_, value, place, "the name of a fault that was injected before");
    if (action == "start" || action == "kill") return expect_in(programs_, value, place, "a program");
    if (action == "inject" && step.contains("as") && !faults_.insert(step.at("as").get<std::string>()).second)
      return fmt::format("{}/as: expected a name of its own, got {}", path, json_text::quote(step.at("as")));
    return std::nullopt;
  }

  Complaint check_unit(const json& keys, const Alternative& row, const std::string& path) const {
    if (std::ranges::count(row.beside, "unit", &Key::key) == 0) return std::nullopt;
    if (row.key.form == Form::Fault && is_bus_kind(keys.at("inject").at("kind").get<std::string>()))
      return std::nullopt;
    if (const auto unit = keys.find("unit"); unit != keys.end())
      return expect_in(units_, *unit, path + "/unit", "a unit");
    if (units_.size() == 1) return std::nullopt;
    return fmt::format("{}/unit: expected the name of a unit, is missing and there are {} units", path,
                       units_.size());
  }

  Complaint check_condition(const json& condition, const std::string& path) const {
    const Alternative& row = *alternative_of(condition, conditions());
    if (Complaint complaint = check_unit(condition, row, path)) return complaint;
    if (row.key.key == "hits")
      return expect_in(faults_, condition.at("hits"), path + "/hits",
                       "the name of a fault that was injected before");
    if (row.key.key == "ended") return expect_in(programs_, condition.at("ended"), path + "/ended", "a program");
    return std::nullopt;
  }

  Complaint check_until(const json& step, const std::string& path) const {
    if (step.contains("for_ms")) return fmt::format("{}/until: expected either for_ms or until, got both", path);
    return expect_in(steps_, step.at("until"), path + "/until", "the name of a step");
  }

  static Complaint check_call(const json& name, const json& params, const std::string& path) {
    const auto method = std::ranges::find(control::kMethods, name.get<std::string>(), &control::Method::name);
    if (method == control::kMethods.end())
      return fmt::format("{}/call: expected a method of the control socket, got {}", path, json_text::quote(name));
    if (const auto checked = control::check(*method, params, kMostAxes); !checked)
      return fmt::format("{}/params: {}", path, checked.error());
    return std::nullopt;
  }

  const json& scenario_;
  Names units_, programs_, steps_, senders_, faults_;
};

}  // namespace

std::optional<std::string> find_wrong_name(const json& scenario) {
  return StepNames{scenario}.check();
}

}  // namespace scenario
