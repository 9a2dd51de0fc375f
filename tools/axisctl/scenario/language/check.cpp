#include "tools/axisctl/scenario/language/check.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "injection/json/fault_json.hpp"
#include "json/strict.hpp"
#include "tools/axisctl/scenario/language/fault_kinds.hpp"
#include "tools/axisctl/scenario/language/forms.hpp"

namespace scenario {
namespace {

using nlohmann::json;
using Complaint = std::optional<std::string>;
using Keys = std::vector<const Key*>;

constexpr std::size_t kMostElements = 1000;

std::string wrong(const std::string& path, std::string_view expected, const json& got) {
  return fmt::format("{}: expected {}, got {}", path.empty() ? "/" : path, expected, json_text::quote(got));
}

Complaint check_value(const json& value, const Key& key, const std::string& path);

Complaint check_keys(const json& object, const Keys& keys, const std::string& path) {
  std::vector<std::string_view> names;
  for (const Key* key : keys) names.push_back(key->key);
  for (const auto& item : object.items())
    if (std::ranges::count(names, item.key()) == 0)
      return fmt::format("{}/{}: unknown key, expected one of: {}", path, json_text::quoted_key(item.key()),
                         fmt::join(names, ", "));
  for (const Key* key : keys) {
    const auto found = object.find(key->key);
    if (found == object.end() && !key->absent.empty()) continue;
    const std::string place = fmt::format("{}/{}", path, key->key);
    if (found == object.end()) return fmt::format("{}: expected, is missing", place);
    if (Complaint complaint = check_value(*found, *key, place)) return complaint;
  }
  return std::nullopt;
}

void add(Keys& keys, std::span<const Key> more) {
  for (const Key& key : more) keys.push_back(&key);
}

/// An object in which one of @p rows decides what else there is, beside @p common.
Complaint check_alternative(const json& object, std::span<const Alternative> rows, std::span<const Key> common,
                            const std::string& path) {
  if (!object.is_object()) return wrong(path, "an object", object);
  const Alternative* const row = alternative_of(object, rows);
  if (row == nullptr) {
    std::vector<std::string_view> names;
    for (const Alternative& other : rows) names.push_back(other.key.key);
    return wrong(path, fmt::format("one of the keys {}", fmt::join(names, ", ")), object);
  }
  Keys keys{&row->key};
  add(keys, row->beside);
  add(keys, common);
  return check_keys(object, keys, path);
}

Complaint check_list(const json& value, const std::string& path,
                     const std::function<Complaint(const json&, const std::string&)>& check) {
  if (!value.is_array() || value.size() > kMostElements)
    return wrong(path, fmt::format("a list of at most {}", kMostElements), value);
  for (std::size_t i = 0; i < value.size(); ++i)
    if (Complaint complaint = check(value[i], fmt::format("{}/{}", path, i))) return complaint;
  return std::nullopt;
}

Complaint check_objects(const json& value, std::span<const Key> keys, const std::string& path) {
  return check_list(value, path, [keys](const json& element, const std::string& place) -> Complaint {
    if (!element.is_object()) return wrong(place, "an object", element);
    Keys all;
    add(all, keys);
    return check_keys(element, all, place);
  });
}

Complaint check_fault(const json& value, const std::string& path) {
  const auto fault = injection::read_fault(value, fault_kinds());
  if (fault) return std::nullopt;
  const injection::Problem& problem = fault.error();
  const std::string place = problem.key.empty() ? path : path + "/" + problem.key;
  if (problem.got.empty()) return fmt::format("{}: expected {}", place, problem.expected);
  return fmt::format("{}: expected {}, got {}", place, problem.expected, problem.got);
}

Complaint check_value(const json& value, const Key& key, const std::string& path) {
  if (const FormRow* const row = row_of(key.form)) {
    if (row->fits(value, key)) return std::nullopt;
    return wrong(path, row->expected(key), value);
  }
  switch (key.form) {
    case Form::Fault:
      return check_fault(value, path);
    case Form::Faults:
      return check_list(value, path, check_fault);
    case Form::Condition:
      return check_alternative(value, conditions(), {}, path);
    case Form::State:
      return check_alternative(value, conditions().subspan(1), {}, path);
    case Form::Bus: {
      if (!value.is_object()) return wrong(path, "an object", value);
      Keys keys;
      add(keys, bus_keys());
      return check_keys(value, keys, path);
    }
    case Form::Units:
      return check_objects(value, unit_keys(), path);
    case Form::Programs:
      return check_objects(value, program_keys(), path);
    default:
      return check_list(value, path, [](const json& step, const std::string& place) {
        return check_alternative(step, actions(), step_keys(), place);
      });
  }
}

}  // namespace

const Alternative* alternative_of(const json& object, std::span<const Alternative> rows) {
  const auto row = std::ranges::find_if(
      rows, [&object](const Alternative& candidate) { return object.contains(candidate.key.key); });
  return row == rows.end() ? nullptr : &*row;
}

std::optional<std::string> find_mistake(const json& value) {
  if (!value.is_object()) return wrong("", "an object", value);
  Keys keys;
  add(keys, scenario_keys());
  return check_keys(value, keys, "");
}

}  // namespace scenario
