#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "daemon/configuration/base/json_reader.hpp"
#include "motor/validation/validation.hpp"

namespace axisd {

/// A number in a JSON object and where it belongs; the factor makes the unit in the key an SI unit.
template <class Data>
struct QuantityKey {
  std::string_view key;
  std::string_view member;  ///< as motor::Impossible names it
  double& (*value)(Data&);
  double factor = 1.0;
};

/// The number that @p path, member by member, leads to.
template <class Data, auto... path>
double& quantity(Data& data) {
  return (data.*....*path);
}

/// Takes those of @p keys that @p json has.
template <class Data>
void read_quantities(const JsonReader& json, std::span<const QuantityKey<Data>> keys, Data& data) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  for (const QuantityKey<Data>& row : keys) {
    const std::string key{row.key};
    if (json.has(key)) row.value(data) = row.factor * json.at(key).number(-kUnlimited, kUnlimited);
  }
}

/// Throws ConfigurationError where @p json says one quantity with two of @p keys.
template <class Data>
void refuse_doubles(const JsonReader& json, std::span<const QuantityKey<Data>> keys) {
  for (const QuantityKey<Data>& row : keys)
    for (const QuantityKey<Data>& other : keys) {
      const std::string key{row.key};
      const std::string second{other.key};
      if (key != second && row.member == other.member && json.has(key) && json.has(second))
        json.at(second).fail(fmt::format("{} or {}, not both", key, second));
    }
}

/// Throws ConfigurationError at the key of what is @p impossible, if anything is.
template <class Data>
void refuse(const JsonReader& json, std::span<const QuantityKey<Data>> keys,
            const std::optional<motor::Impossible>& impossible) {
  if (!impossible) return;
  std::string key{impossible->member};
  for (const QuantityKey<Data>& row : keys)
    if (row.member == impossible->member && (!json.has(key) || json.has(std::string{row.key}))) key = row.key;
  if (json.has(key)) json.at(key).fail(std::string{impossible->expected});
  json.fail(fmt::format("a value for {} that is {}", key, impossible->expected));
}

}  // namespace axisd
