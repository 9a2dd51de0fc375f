#include "trace/json/fields.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "text/number.hpp"

namespace trace {

void Fields::expect_keys(std::span<const std::string_view> keys) const {
  for (const auto& [key, value] : object_.items()) {
    if (std::ranges::find(keys, key) == keys.end())
      fail(key, fmt::format("one of the keys {}", fmt::join(keys, ", ")));
  }
}

const nlohmann::json* Fields::find(std::string_view key) const {
  const auto found = object_.find(key);
  return found == object_.end() || found->is_null() ? nullptr : &*found;
}

void Fields::fail(std::string_view key, std::string expected) const {
  if (!problem_) problem_ = Problem{Problem::Kind::Malformed, path_ + std::string{key}, std::move(expected)};
}

std::optional<double> Fields::number(std::string_view key, double low, double high) const {
  const json* const value = find(key);
  if (value != nullptr && value->is_number() && *value >= low && *value <= high) return value->get<double>();
  fail(key, fmt::format("a number {:g} to {:g}", low, high));
  return std::nullopt;
}

std::optional<std::uint64_t> Fields::integer(std::string_view key, std::uint64_t low, std::uint64_t high) const {
  const json* const value = find(key);
  const bool is_whole = value != nullptr && value->is_number_integer() && *value >= 0;
  if (is_whole && value->get<std::uint64_t>() >= low && value->get<std::uint64_t>() <= high)
    return value->get<std::uint64_t>();
  fail(key, fmt::format("an integer {} to {}", low, high));
  return std::nullopt;
}

std::optional<bool> Fields::flag(std::string_view key) const {
  const json* const value = find(key);
  if (value != nullptr && value->is_boolean()) return value->get<bool>();
  fail(key, "true or false");
  return std::nullopt;
}

std::optional<std::string> Fields::text(std::string_view key, const char* expected) const {
  const json* const value = find(key);
  if (value != nullptr && value->is_string()) return value->get<std::string>();
  fail(key, expected);
  return std::nullopt;
}

std::optional<std::uint32_t> Fields::word(std::string_view key, std::uint32_t high) const {
  const json* const value = find(key);
  std::optional<std::uint32_t> word;
  if (value != nullptr && value->is_number_integer() && *value >= 0 && *value <= high)
    word = value->get<std::uint32_t>();
  if (value != nullptr && value->is_string()) {
    std::string_view digits = value->get_ref<const std::string&>();
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    if (digits.ends_with('h')) digits.remove_suffix(1);
    word = text::integer<std::uint32_t>(digits, 16);
  }
  if (word && *word <= high) return word;
  fail(key, fmt::format("an integer 0 to {0}, or hexadecimal digits up to \"{0:X}\"", high));
  return std::nullopt;
}

}  // namespace trace
