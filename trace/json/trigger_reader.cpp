#include "trace/json/trigger_reader.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "text/number.hpp"
#include "trace/json/fields.hpp"
#include "trace/trigger_table.hpp"

namespace trace {
namespace {

using nlohmann::json;

constexpr double kHighest = 1e12;
constexpr std::uint32_t kHighestWord = 0xFFFFFFFF;
constexpr std::uint32_t kHighestIdentifier = 0x7FF;
constexpr std::uint32_t kHighestLongIdentifier = 0x1FFFFFFF;

/// Keys that a kind takes with an argument, and what reads them.
struct ArgumentRow {
  TriggerArgument argument;
  std::array<std::string_view, 6> keys;
  void (*read)(const Fields& fields, TriggerSettings& trigger);
};

void read_signal(const Fields& fields, TriggerSettings& trigger) {
  trigger.signal = fields.text("signal", "the name of a signal").value_or("");
}

void read_level(const Fields& fields, TriggerSettings& trigger) {
  trigger.level = fields.number("level", -kHighest, kHighest).value_or(0.0);
}

void read_band(const Fields& fields, TriggerSettings& trigger) {
  trigger.low = fields.number("low", -kHighest, kHighest).value_or(0.0);
  trigger.high = fields.number("high", -kHighest, kHighest).value_or(0.0);
}

void read_bits(const Fields& fields, TriggerSettings& trigger) {
  trigger.value = fields.word("value", kHighestWord).value_or(0);
  if (fields.has("mask")) trigger.mask = fields.word("mask", kHighestWord).value_or(0);
}

void read_place(const Fields& fields, TriggerSettings& trigger) {
  const json* const axis = fields.find("axis");
  if (axis == nullptr) return;
  if (axis->is_number_integer()) trigger.place = parse_place(axis->dump());
  if (axis->is_string()) trigger.place = parse_place(axis->get_ref<const std::string&>());
  if (!trigger.place) fields.fail("axis", fmt::format("0 to {} or \"infeed\"", drive::kMostAxes));
}

/// 7860, "F07860" or "7860".
void read_number(const Fields& fields, TriggerSettings& trigger) {
  const json* const value = fields.find("number");
  if (value == nullptr) return;
  constexpr std::uint16_t kMost = 65535;
  std::optional<std::uint16_t> number;
  if (value->is_number_integer() && *value >= 1 && *value <= kMost) number = value->get<std::uint16_t>();
  if (value->is_string()) {
    std::string_view digits = value->get_ref<const std::string&>();
    if (digits.starts_with('F') || digits.starts_with('A')) digits.remove_prefix(1);
    number = text::integer<std::uint16_t>(digits);
  }
  const bool exists = number && drive::find_fault(*number) != nullptr;
  if (!exists) return fields.fail("number", "a fault or alarm of the unit, such as 7860");
  trigger.number = *number;
}

/// Letters without case, and any sign between words.
bool is_same_name(std::string_view a, std::string_view b) noexcept {
  const auto plain = [](char letter) noexcept {
    if (letter == '-' || letter == '_') return ' ';
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  };
  return std::ranges::equal(a, b, {}, plain, plain);
}

void read_state(const Fields& fields, TriggerSettings& trigger) {
  const auto name = fields.text("state", "the name of a drive state").value_or("");
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < drive::kStateCount; ++i) {
    trigger.state = static_cast<drive::State>(i);
    names.push_back(name_of(trigger.state));
    if (is_same_name(names.back(), name)) return;
  }
  fields.fail("state", fmt::format("one of {}", fmt::join(names, ", ")));
}

/// Data bytes as hexadecimal digits; nothing if they are none.
std::optional<std::vector<std::uint8_t>> bytes_of(const Fields& fields, std::string_view key) {
  const std::string digits = fields.text(key, "hexadecimal digits of up to 8 bytes").value_or("");
  constexpr std::size_t kMost = 8;
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    const auto byte = text::integer<std::uint8_t>(std::string_view{digits}.substr(i, 2), 16);
    if (!byte) break;
    bytes.push_back(*byte);
  }
  if (2 * bytes.size() == digits.size() && bytes.size() <= kMost) return bytes;
  fields.fail(key, "hexadecimal digits of up to 8 bytes");
  return std::nullopt;
}

void read_data(const Fields& fields, FramePattern& frame) {
  if (!fields.has("data")) return;
  const auto data = bytes_of(fields, "data");
  if (!data) return;
  frame.length = static_cast<std::uint8_t>(data->size());
  std::ranges::copy(*data, frame.data.begin());
  frame.data_mask.fill(0xFF);
  if (!fields.has("data_mask")) return;
  const auto mask = bytes_of(fields, "data_mask");
  if (!mask) return;
  if (mask->size() != data->size()) return fields.fail("data_mask", "as many bytes as `data` has");
  std::ranges::copy(*mask, frame.data_mask.begin());
}

void read_frame(const Fields& fields, TriggerSettings& trigger) {
  FramePattern& frame = trigger.frame;
  if (fields.has("extended")) frame.extended = fields.flag("extended").value_or(false);
  const std::uint32_t highest = frame.extended ? kHighestLongIdentifier : kHighestIdentifier;
  frame.id = fields.word("id", highest).value_or(0);
  if (fields.has("id_mask")) frame.id_mask = fields.word("id_mask", highest).value_or(0);
  read_data(fields, frame);
  if (!fields.has("direction")) return;
  const std::string way = fields.text("direction", "received or sent").value_or("");
  if (way == "received") frame.direction = Direction::Received;
  if (way == "sent") frame.direction = Direction::Sent;
  if (!frame.direction) fields.fail("direction", "received or sent");
}

constexpr std::array kArguments{
    ArgumentRow{kTakesSignal, {"signal"}, &read_signal},
    ArgumentRow{kTakesLevel, {"level"}, &read_level},
    ArgumentRow{kTakesBand, {"low", "high"}, &read_band},
    ArgumentRow{kTakesBits, {"mask", "value"}, &read_bits},
    ArgumentRow{kTakesPlace, {"axis"}, &read_place},
    ArgumentRow{kTakesNumber, {"number"}, &read_number},
    ArgumentRow{kTakesState, {"state"}, &read_state},
    ArgumentRow{kTakesFrame, {"id", "id_mask", "extended", "data", "data_mask", "direction"}, &read_frame},
};

/// "rising signal=1/speed level=700" as an object.
json object_of(std::string_view words) {
  json object = json::object();
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (word.empty()) continue;
    const std::size_t sign = word.find('=');
    if (sign == std::string_view::npos) {
      object["on"] = word;
      continue;
    }
    const std::string key{word.substr(0, sign)};
    const std::string_view text = word.substr(sign + 1);
    const bool is_number = key == "level" || key == "low" || key == "high";
    const auto number = is_number ? text::real(text) : std::nullopt;
    if (number)
      object[key] = *number;
    else if (key == "extended")
      object[key] = text == "true";
    else
      object[key] = text;
  }
  return object;
}

std::string kinds() {
  std::vector<std::string_view> names;
  for (const TriggerRow& row : trigger_rows()) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

TriggerSettings read_trigger(const json& value, std::optional<Problem>& problem) {
  const json object = value.is_string() ? object_of(value.get_ref<const std::string&>()) : value;
  TriggerSettings trigger;
  const Fields fields{object, "trigger.", problem};
  if (!object.is_object()) {
    if (!problem) problem = Problem{Problem::Kind::Malformed, "trigger", "an object with the key `on`"};
    return trigger;
  }
  const auto name = fields.text("on", "the kind of trigger").value_or("");
  const TriggerRow* const row = find_trigger(name);
  if (row == nullptr) {
    fields.fail("on", fmt::format("one of {}", kinds()));
    return trigger;
  }
  trigger.kind = row->kind;
  std::vector<std::string_view> keys{"on"};
  for (const ArgumentRow& argument : kArguments) {
    if ((row->arguments & argument.argument) == 0) continue;
    argument.read(fields, trigger);
    std::ranges::copy_if(argument.keys, std::back_inserter(keys),
                         [](std::string_view key) { return !key.empty(); });
  }
  fields.expect_keys(keys);
  return trigger;
}

}  // namespace trace
