#include "daemon/configuration/inject_reader.hpp"

#include <algorithm>
#include <set>

#include "injection/json/fault_json.hpp"
#include "injection/kinds/unit_kinds.hpp"

namespace axisd {
namespace {

/// The keys of the kind that @p json names, or else those of all kinds.
std::vector<std::string_view> keys_for(const JsonReader& json) {
  const auto kinds = injection::unit_kinds();
  const bool has_name = json.has("kind") && json.at("kind").is_string();
  const auto kind =
      has_name ? std::ranges::find(kinds, json.at("kind").text(), &injection::Kind::name) : kinds.end();
  if (kind != kinds.end()) return injection::keys_of(*kind);
  std::set<std::string_view> keys;
  for (const injection::Kind& each : kinds)
    for (const std::string_view key : injection::keys_of(each)) keys.insert(key);
  return {keys.begin(), keys.end()};
}

injection::Fault read_fault(const JsonReader& json) {
  json.expect_object(keys_for(json));
  const auto fault = injection::read_fault(json.value(), injection::unit_kinds());
  if (fault) return *fault;
  const injection::Problem& problem = fault.error();
  if (json.has(problem.key)) json.at(problem.key).fail(problem.expected);
  json.fail_below(problem.key, problem.expected);
}

}  // namespace

std::vector<injection::Fault> read_faults(const JsonReader& json) {
  constexpr std::size_t kMost = 64;  // of UnitFaults
  json.expect_array(0, kMost);
  std::vector<injection::Fault> faults;
  for (std::size_t i = 0; i < json.size(); ++i) faults.push_back(read_fault(json.at(i)));
  return faults;
}

}  // namespace axisd
