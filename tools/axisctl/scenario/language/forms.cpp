#include "tools/axisctl/scenario/language/forms.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/axisctl/scenario/language/frame_pattern.hpp"

namespace scenario {
namespace {

using nlohmann::json;

bool is_text(const json& value) {
  return value.is_string() && !value.get_ref<const std::string&>().empty();
}
std::string_view text_of(const json& value) {
  return value.get_ref<const std::string&>();
}
bool is_word(const json& value) {
  return is_text(value) && std::ranges::all_of(text_of(value), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
                  c == '_';
         });
}
bool is_entry(const json& value) {
  if (!is_text(value)) return false;
  const std::string_view text = text_of(value);
  const auto is_digit = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
  constexpr std::size_t kIndex = 4, kBoth = 7;
  if (text.size() != kIndex && text.size() != kBoth) return false;
  return std::ranges::all_of(text.substr(0, kIndex), is_digit) &&
         (text.size() == kIndex ||
          (text[kIndex] == ':' && std::ranges::all_of(text.substr(kIndex + 1), is_digit)));
}
bool is_within(const json& value, const Key& key) {
  return value.is_number() && value.get<double>() >= key.low && value.get<double>() <= key.high;
}
std::string range_of(const Key& key, std::string_view what) {
  constexpr double kNoLimit = 1e200;
  if (key.high > kNoLimit) return fmt::format("a {}", what);
  return fmt::format("{} {} {} to {}", what == "integer" ? "an" : "a", what, key.low, key.high);
}
json numbers(const Key& key, std::string_view type) {
  constexpr double kNoLimit = 1e200;
  json schema{{"type", type}};
  if (key.high > kNoLimit) return schema;
  schema["minimum"] = type == "integer" ? json(static_cast<std::int64_t>(key.low)) : json(key.low);
  schema["maximum"] = type == "integer" ? json(static_cast<std::int64_t>(key.high)) : json(key.high);
  return schema;
}
json pattern_of(const char* pattern) {
  return {{"type", "string"}, {"pattern", pattern}};
}

const std::array kForms{
    FormRow{Form::Text, [](const json& value, const Key&) { return is_text(value); },
            [](const Key&) { return std::string{"a text"}; },
            [](const Key&) {
              return json{{"type", "string"}, {"minLength", 1}};
            }},
    FormRow{Form::Texts,
            [](const json& value, const Key&) {
              return is_text(value) || (value.is_array() && !value.empty() && std::ranges::all_of(value, is_text));
            },
            [](const Key&) { return std::string{"a text or a list of texts"}; },
            [](const Key&) {
              const json text{{"type", "string"}, {"minLength", 1}};
              return json{{"anyOf", {text, {{"type", "array"}, {"minItems", 1}, {"items", text}}}}};
            }},
    FormRow{Form::Word, [](const json& value, const Key&) { return is_word(value); },
            [](const Key&) { return std::string{"a name of letters, digits, - and _"}; },
            [](const Key&) { return pattern_of("^[A-Za-z0-9_-]+$"); }},
    FormRow{Form::Integer,
            [](const json& value, const Key& key) { return value.is_number_integer() && is_within(value, key); },
            [](const Key& key) { return range_of(key, "integer"); },
            [](const Key& key) { return numbers(key, "integer"); }},
    FormRow{Form::Number, is_within, [](const Key& key) { return range_of(key, "number"); },
            [](const Key& key) { return numbers(key, "number"); }},
    FormRow{Form::Boolean, [](const json& value, const Key&) { return value.is_boolean(); },
            [](const Key&) { return std::string{"true or false"}; },
            [](const Key&) {
              return json{{"type", "boolean"}};
            }},
    FormRow{Form::Choice,
            [](const json& value, const Key& key) {
              return value.is_string() && std::ranges::count(key.choices, text_of(value)) != 0;
            },
            [](const Key& key) { return fmt::format("one of {}", fmt::join(key.choices, ", ")); },
            [](const Key& key) {
              return json{{"enum", key.choices}};
            }},
    FormRow{Form::Frame,
            [](const json& value, const Key&) { return value.is_string() && parse_frame(text_of(value)); },
            [](const Key&) { return std::string{"a frame as candump prints it, such as 205#0F00 or 705#R"}; },
            [](const Key&) {
              return pattern_of("^([0-7][0-9A-Fa-f]{2}|[01][0-9A-Fa-f]{7})#(R[0-8]?|([0-9A-Fa-f]{2}){0,8})$");
            }},
    FormRow{
        Form::Pattern,
        [](const json& value, const Key&) { return value.is_string() && parse_pattern(text_of(value)); },
        [](const Key&) { return std::string{"a frame such as 185, 185#37xx or 585#80*, where x is any digit"}; },
        [](const Key&) {
          return pattern_of(
              "^([0-7xX][0-9A-Fa-fxX]{2}|[01xX][0-9A-Fa-fxX]{7})(#(R[0-8]?|([0-9A-Fa-fxX]{2}){0,8}[*]?))?$");
        }},
    FormRow{Form::Bytes,
            [](const json& value, const Key&) { return value.is_string() && parse_bytes(text_of(value)); },
            [](const Key&) { return std::string{"at most eight bytes in hexadecimal, such as 4F00"}; },
            [](const Key&) { return pattern_of("^([0-9A-Fa-f]{2}){0,8}$"); }},
    FormRow{Form::Entry, [](const json& value, const Key&) { return is_entry(value); },
            [](const Key&) { return std::string{"an object in hexadecimal, such as 6041 or 1018:04"}; },
            [](const Key&) { return pattern_of("^[0-9A-Fa-f]{4}(:[0-9A-Fa-f]{2})?$"); }},
    FormRow{
        Form::Scalar,
        [](const json& value, const Key&) { return value.is_number() || value.is_string() || value.is_boolean(); },
        [](const Key&) { return std::string{"a number, a text, true or false"}; },
        [](const Key&) {
          return json{{"type", {"number", "string", "boolean"}}};
        }},
    FormRow{Form::Object, [](const json& value, const Key&) { return value.is_object(); },
            [](const Key&) { return std::string{"an object"}; },
            [](const Key&) {
              return json{{"type", "object"}};
            }},
};

}  // namespace

const FormRow* row_of(Form form) noexcept {
  const auto row = std::ranges::find(kForms, form, &FormRow::form);
  return row == kForms.end() ? nullptr : &*row;
}

}  // namespace scenario
