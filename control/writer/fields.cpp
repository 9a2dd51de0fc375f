#include "control/writer/fields.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace control {

Fields::Fields(const Json& object, std::string place, std::span<const std::string_view> known)
    : object_{object}, place_{std::move(place)} {
  if (!object.is_object()) throw std::runtime_error{place_ + ": expected an object, got " + object.dump()};
  for (const auto& item : object.items())
    if (std::ranges::find(known, item.key()) == known.end())
      throw std::runtime_error{
          fmt::format("{}/{}: unknown key, expected one of: {}", place_, item.key(), fmt::join(known, ", "))};
}

const Json* Fields::find(std::string_view key) const {
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

void Fields::refuse(std::string_view key, std::string_view expected) const {
  const Json* const value = find(key);
  throw std::runtime_error{
      fmt::format("{}: expected {}, got {}", place(key), expected, value == nullptr ? "nothing" : value->dump())};
}

std::string_view Fields::text(std::string_view key) const {
  const Json* const value = find(key);
  if (value == nullptr || !value->is_string() || value->get_ref<const std::string&>().empty())
    refuse(key, "a text");
  return value->get_ref<const std::string&>();
}

std::string_view Fields::text(std::string_view key, std::string_view otherwise) const {
  return has(key) ? text(key) : otherwise;
}

double Fields::number(std::string_view key) const {
  const Json* const value = find(key);
  if (value == nullptr || !value->is_number()) refuse(key, "a number");
  return value->get<double>();
}

bool Fields::flag(std::string_view key, bool otherwise) const {
  const Json* const value = find(key);
  if (value != nullptr && !value->is_boolean()) refuse(key, "true or false");
  return value == nullptr ? otherwise : value->get<bool>();
}

const Json& Fields::list(std::string_view key) const {
  static const Json kNone = Json::array();
  const Json* const value = find(key);
  if (value != nullptr && !value->is_array()) refuse(key, "a list");
  return value == nullptr ? kNone : *value;
}

const Json& Fields::object(std::string_view key) const {
  static const Json kNone = Json::object();
  const Json* const value = find(key);
  if (value != nullptr && !value->is_object()) refuse(key, "an object");
  return value == nullptr ? kNone : *value;
}

}  // namespace control
