#include "eds/catalogue/json_fields.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "eds/catalogue/catalogue.hpp"
#include "eds/catalogue/number.hpp"

namespace eds {
namespace {

bool is_printable(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

JsonFields::JsonFields(const nlohmann::json& object, std::string place, std::span<const std::string_view> known)
    : object_{object}, place_{std::move(place)} {
  if (!object.is_object()) throw CatalogueError{place_ + ": expected an object, got " + object.dump()};
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    throw CatalogueError{
        fmt::format("{}: unknown field \"{}\": expected one of {}", place_, key, fmt::join(known, ", "))};
  }
}

bool JsonFields::has(std::string_view key) const {
  return object_.contains(key);
}

std::string JsonFields::text(std::string_view key) const {
  constexpr std::string_view kExpected = "a text of printable ASCII";
  const nlohmann::json& value = at(key, kExpected);
  if (!value.is_string() || !is_printable(value.get_ref<const std::string&>())) fail(key, kExpected);
  return value.get<std::string>();
}

std::vector<std::string> JsonFields::texts(std::string_view key) const {
  constexpr std::string_view kExpected = "a list of texts of printable ASCII";
  const nlohmann::json& list = at(key, kExpected);
  if (!list.is_array()) fail(key, kExpected);
  for (const nlohmann::json& line : list)
    if (!line.is_string() || !is_printable(line.get_ref<const std::string&>())) fail(key, kExpected);
  return list.get<std::vector<std::string>>();
}

bool JsonFields::boolean(std::string_view key) const {
  const nlohmann::json& value = at(key, "true or false");
  if (!value.is_boolean()) fail(key, "true or false");
  return value.get<bool>();
}

std::int64_t JsonFields::integer(std::string_view key, std::int64_t high) const {
  const std::string expected = fmt::format("an integer 0 to {}", high);
  const nlohmann::json& value = at(key, expected);
  if (!value.is_number_integer() || value < 0 || value > high) fail(key, expected);
  return value.get<std::int64_t>();
}

std::uint16_t JsonFields::hexadecimal(std::string_view key) const {
  const auto value = parse_hexadecimal(text(key), 4);
  if (!value) fail(key, "four hexadecimal digits");
  return static_cast<std::uint16_t>(*value);
}

void JsonFields::fail(std::string_view key, std::string_view expected) const {
  const auto found = object_.find(key);
  const std::string got = found == object_.end() ? "nothing" : found->dump();
  throw CatalogueError{fmt::format("{}: field \"{}\": expected {}, got {}", place_, key, expected, got)};
}

const nlohmann::json& JsonFields::at(std::string_view key, std::string_view expected) const {
  const auto found = object_.find(key);
  if (found == object_.end()) fail(key, expected);
  return *found;
}

nlohmann::json parse_json(std::string_view text) {
  // nlohmann keeps the last of two equal keys without a word; a source of truth must not.
  std::vector<std::set<std::string>> open;
  const auto watch = [&open](int, nlohmann::json::parse_event_t event, nlohmann::json& value) {
    if (event == nlohmann::json::parse_event_t::object_start) open.emplace_back();
    if (event == nlohmann::json::parse_event_t::object_end) open.pop_back();
    if (event == nlohmann::json::parse_event_t::key && !open.back().insert(value.get<std::string>()).second)
      throw CatalogueError{fmt::format("field {} stands twice in one object: expected it once", value.dump())};
    return true;
  };
  try {
    return nlohmann::json::parse(text, watch);
  } catch (const nlohmann::json::parse_error& error) {
    throw CatalogueError{fmt::format("not JSON: {}", error.what())};
  }
}

}  // namespace eds
