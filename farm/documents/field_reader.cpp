#include "farm/documents/field_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "farm/naming/unit_name.hpp"
#include "json/strict.hpp"

namespace farm {
namespace {

using nlohmann::json;

constexpr std::string_view kName = "a name of 1 to 32 letters, digits, '-' and '_'";
constexpr std::string_view kNames = "a name of 1 to 32 letters, digits, '-' and '_', or a list of them";

/// @p text in one line, whatever is in it.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return text;
}

}  // namespace

FieldReader::FieldReader(std::string_view subject, std::string_view text) : subject_{subject} {
  auto parsed = json_text::parse(text);
  if (!parsed)
    take(fmt::format("{}: {}", subject_, parsed.error()));
  else if (!parsed->is_object())
    take(fmt::format("{}: expected an object, got {}", subject_, json_text::quote(*parsed)));
  else
    object_ = *std::move(parsed);
}

FieldReader::FieldReader(std::string subject, const json& object) : subject_{std::move(subject)} {
  if (object.is_object())
    object_ = object;
  else
    take(fmt::format("{}: expected an object, got {}", subject_, json_text::quote(object)));
}

void FieldReader::allow_only(std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object_.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    fail(json_text::quoted_key(key), fmt::format("only {}", fmt::join(known, ", ")), value);
  }
}

std::uint64_t FieldReader::number(const char* key, std::uint64_t low, std::uint64_t high, std::uint64_t absent) {
  return has(key) ? number(key, low, high) : absent;
}

std::uint64_t FieldReader::number(const char* key, std::uint64_t low, std::uint64_t high) {
  const json* const value = member(key);
  if (value != nullptr && value->is_number_unsigned()) {
    const auto number = value->get<std::uint64_t>();
    if (number >= low && number <= high) return number;
  }
  fail(key, fmt::format("an integer {} to {}", low, high), value == nullptr ? json{} : *value);
  return low;
}

bool FieldReader::flag(const char* key, bool absent) {
  const json* const value = member(key);
  if (value == nullptr) return absent;
  if (value->is_boolean()) return value->get<bool>();
  fail(key, "true or false", *value);
  return absent;
}

std::string FieldReader::text(const char* key) {
  const json* const value = member(key);
  if (value == nullptr) return {};
  if (value->is_string()) return in_one_line(value->get<std::string>());
  fail(key, "a text", *value);
  return {};
}

std::string FieldReader::name(const char* key) {
  const json* const value = member(key);
  if (value == nullptr) return {};
  if (value->is_string() && is_name(value->get_ref<const std::string&>())) return value->get<std::string>();
  fail(key, kName, *value);
  return {};
}

std::vector<std::string> FieldReader::names(const char* key) {
  const json* const value = member(key);
  if (value == nullptr) return {};
  std::vector<std::string> found;
  for (const json& each : value->is_array() ? *value : json::array({*value})) {
    if (each.is_string() && is_name(each.get_ref<const std::string&>()))
      found.push_back(each.get<std::string>());
    else
      fail(key, kNames, *value);
  }
  if (found.empty()) fail(key, kNames, *value);
  return found;
}

json FieldReader::object(const char* key) {
  const json* const value = member(key);
  if (value != nullptr && value->is_object()) return *value;
  fail(key, "an object", value == nullptr ? json{} : *value);
  return json::object();
}

std::vector<json> FieldReader::objects(const char* key) {
  const json* const value = member(key);
  if (value == nullptr) return {};
  if (value->is_array()) return {value->begin(), value->end()};
  fail(key, "a list of objects", *value);
  return {};
}

void FieldReader::fail(std::string_view path, std::string_view expected, const json& got) {
  take(fmt::format("{}: {}: expected {}, got {}", subject_, path, expected,
                   got.is_null() ? "nothing" : json_text::quote(got)));
}

void FieldReader::take(const std::string& error) {
  if (error_.empty()) error_ = error;
}

const json* FieldReader::member(const char* key) const {
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

}  // namespace farm
