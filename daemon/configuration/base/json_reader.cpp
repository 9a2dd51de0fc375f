#include "daemon/configuration/base/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "daemon/configuration/base/configuration_error.hpp"
#include "json/strict.hpp"

namespace axisd {
namespace {

using json_text::quote;
using json_text::quoted_key;

}  // namespace

JsonReader JsonReader::parse(std::string_view text, const std::string& file) {
  auto parsed = json_text::parse(text);
  if (!parsed) throw ConfigurationError{file + ": " + parsed.error()};
  return JsonReader{*std::move(parsed), file, ""};
}

std::string JsonReader::place() const {
  return file_ + ": " + (path_.empty() ? "/" : path_);
}

void JsonReader::fail(const std::string& expected) const {
  throw ConfigurationError{fmt::format("{}: expected {}, got {}", place(), expected, quote(value_))};
}

void JsonReader::fail_below(const std::string& path, const std::string& expected) const {
  throw ConfigurationError{fmt::format("{}: {}/{}: expected {}", file_, path_, quoted_key(path), expected)};
}

void JsonReader::expect_object(std::span<const std::string_view> keys) const {
  if (!value_.is_object()) fail("an object");
  for (const auto& item : value_.items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) != keys.end()) continue;
    throw ConfigurationError{fmt::format("{}/{}: unknown key, expected one of: {}", file_ + ": " + path_,
                                         quoted_key(item.key()), fmt::join(keys, ", "))};
  }
}

void JsonReader::expect_array(std::size_t low, std::size_t high) const {
  if (value_.is_array() && value_.size() >= low && value_.size() <= high) return;
  fail(low == high ? fmt::format("an array of {}", low) : fmt::format("an array of {} to {}", low, high));
}

JsonReader JsonReader::at(const std::string& key) const {
  return {value_.at(key), file_, path_ + "/" + key};
}

JsonReader JsonReader::at(std::size_t position) const {
  return {value_.at(position), file_, path_ + "/" + std::to_string(position)};
}

std::vector<std::string> JsonReader::keys() const {
  std::vector<std::string> keys;
  for (const auto& item : value_.items()) keys.push_back(item.key());
  return keys;
}

std::string JsonReader::text() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

bool JsonReader::boolean() const {
  if (!value_.is_boolean()) fail("true or false");
  return value_.get<bool>();
}

int JsonReader::integer(int low, int high) const {
  return static_cast<int>(whole_number(low, high));
}

std::int64_t JsonReader::whole_number(std::int64_t low, std::int64_t high) const {
  const bool fits = value_.is_number_integer() && value_ >= low && value_ <= high;
  if (!fits) fail(fmt::format("an integer {} to {}", low, high));
  return value_.get<std::int64_t>();
}

double JsonReader::number(double low, double high) const {
  const bool fits = value_.is_number() && value_.get<double>() >= low && value_.get<double>() <= high;
  if (!fits) {
    if (std::isinf(low)) fail("a number");
    fail(std::isinf(high) ? fmt::format("a number not below {}", low)
                          : fmt::format("a number {} to {}", low, high));
  }
  return value_.get<double>();
}

}  // namespace axisd
