#include "daemon/control/arguments.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace axisd {
namespace {

using nlohmann::json;

std::string listed(std::span<const std::string_view> choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text.append(i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ").append(choices[i]);
  return text;
}

/// @p absent, or that @p key is missing.
template <class Value>
Taken<Value> without(std::string_view key, std::string_view expected, const std::optional<Value>& absent) {
  if (absent) return *absent;
  return tl::unexpected{unexpected_value(key, expected, nullptr)};
}

}  // namespace

std::string shown(const json& value) {
  constexpr std::size_t kMost = 80;
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > kMost) text.replace(kMost, std::string::npos, "...");
  return text;
}

control::Error unexpected_value(std::string_view key, std::string_view expected, const json* value) {
  return {control::ErrorCode::BadParameter,
          fmt::format("{}: expected {}, got {}", key, expected, value == nullptr ? "nothing" : shown(*value))};
}

const json* Arguments::find(std::string_view key) const noexcept {
  if (!params_.is_object()) return nullptr;
  const auto found = params_.find(key);
  return found == params_.end() || found->is_null() ? nullptr : &*found;
}

Taken<std::int64_t> Arguments::integer(std::string_view key, std::int64_t low, std::int64_t high,
                                       std::optional<std::int64_t> absent) const {
  const std::string expected = fmt::format("an integer {} to {}", low, high);
  const json* const value = find(key);
  if (value == nullptr) return without(key, expected, absent);
  if (value->is_number_integer() && *value >= low && *value <= high) return value->get<std::int64_t>();
  return tl::unexpected{unexpected_value(key, expected, value)};
}

Taken<Page> Arguments::page(const PageLimits& limits) const {
  const auto from = integer("from", 0, limits.last, 0);
  if (!from) return tl::unexpected{from.error()};
  const auto count = integer("count", 1, limits.most, limits.usual);
  if (!count) return tl::unexpected{count.error()};
  return Page{static_cast<std::size_t>(*from), static_cast<std::size_t>(*count)};
}

Taken<double> Arguments::number(std::string_view key, double low, double high,
                                std::optional<double> absent) const {
  const std::string expected = fmt::format("a number {} to {}", low, high);
  const json* const value = find(key);
  if (value == nullptr) return without(key, expected, absent);
  if (value->is_number() && *value >= low && *value <= high) return value->get<double>();
  return tl::unexpected{unexpected_value(key, expected, value)};
}

Taken<bool> Arguments::flag(std::string_view key, std::optional<bool> absent) const {
  const json* const value = find(key);
  if (value == nullptr) return without(key, "true or false", absent);
  if (value->is_boolean()) return value->get<bool>();
  return tl::unexpected{unexpected_value(key, "true or false", value)};
}

Taken<std::string> Arguments::text(std::string_view key, std::optional<std::string> absent) const {
  const json* const value = find(key);
  if (value == nullptr) return without(key, "a text", absent);
  if (!value->is_string()) return tl::unexpected{unexpected_value(key, "a text", value)};
  if (value->get_ref<const std::string&>().size() <= kLongestText) return value->get<std::string>();
  return tl::unexpected{unexpected_value(key, fmt::format("a text of at most {} bytes", kLongestText), value)};
}

Taken<std::size_t> Arguments::choice(std::string_view key, std::span<const std::string_view> choices,
                                     std::optional<std::size_t> absent) const {
  const json* const value = find(key);
  if (value == nullptr) return without(key, listed(choices), absent);
  const auto chosen = std::ranges::find_if(choices, [value](std::string_view choice) { return *value == choice; });
  if (chosen != choices.end()) return static_cast<std::size_t>(chosen - choices.begin());
  return tl::unexpected{unexpected_value(key, listed(choices), value)};
}

}  // namespace axisd
