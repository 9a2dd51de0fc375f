#include "injection/json/fault_json.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "injection/json/choice.hpp"
#include "injection/json/when_rows.hpp"
#include "json/strict.hpp"

namespace injection {
namespace {

using nlohmann::json;

constexpr auto kNatureNames = std::to_array<std::string_view>({"each", "moment", "lasting"});

tl::unexpected<Problem> problem(std::string key, std::string expected, const json* got) {
  return tl::unexpected{Problem{.key = std::move(key),
                                .expected = std::move(expected),
                                .got = got != nullptr ? json_text::quote(*got) : std::string{}}};
}

std::optional<std::uint32_t> argument_in(const json& value, const ArgumentRow& row) {
  if (row.form == Form::Word) {
    const auto word = value.is_string() ? std::ranges::find(row.words, value.get<std::string>()) : row.words.end();
    if (word == row.words.end()) return std::nullopt;
    return static_cast<std::uint32_t>(word - row.words.begin());
  }
  const auto number = whole_number(value, row.form == Form::Hexadecimal);
  const bool is_right = number && *number >= row.low && *number <= row.high;
  return is_right ? std::optional{static_cast<std::uint32_t>(*number)} : std::nullopt;
}

/// A number stands for its digits.
std::optional<std::uint32_t> text_in(const json& value, const ArgumentRow& row, Fault& fault) {
  if (!value.is_string() && !whole_number(value)) return std::nullopt;
  std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (text.size() < row.low || text.size() > row.high) return std::nullopt;
  fault.texts.push_back(std::move(text));
  return static_cast<std::uint32_t>(fault.texts.size() - 1);
}

json argument_json(std::uint32_t value, const ArgumentRow& row, const Fault& fault) {
  if (row.form == Form::Text) return fault.texts[value];
  if (row.form == Form::Word) return row.words[value];
  if (row.form == Form::Hexadecimal) return fmt::format("0x{:X}", value);
  return value;
}

tl::expected<const Kind*, Problem> kind_in(const json& value, std::span<const Kind> kinds) {
  const auto given = value.find("kind");
  const auto found = given != value.end() && given->is_string()
                         ? std::ranges::find(kinds, given->get<std::string>(), &Kind::name)
                         : kinds.end();
  if (found != kinds.end()) return &*found;
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds) names.push_back(kind.name);
  return problem("kind", choice_of(names), given != value.end() ? &*given : nullptr);
}

tl::expected<void, Problem> read_arguments(const json& value, Fault& fault) {
  for (const ArgumentUse& use : fault.kind->arguments) {
    const ArgumentRow& row = row_of(use.argument);
    const auto given = value.find(row.key);
    if (given == value.end()) {
      if (use.absent.empty()) return problem(std::string{row.key}, rule_of(row), nullptr);
      continue;
    }
    auto& argument = fault.arguments[static_cast<std::size_t>(use.argument)];
    argument = row.form == Form::Text ? text_in(*given, row, fault) : argument_in(*given, row);
    if (!argument) return problem(std::string{row.key}, rule_of(row), &*given);
  }
  return {};
}

tl::expected<void, Problem> read_when(const json& value, Fault& fault) {
  for (const WhenRow& row : when_rows()) {
    const auto given = value.find(row.key);
    if (given != value.end() && !row.read(*given, fault.when))
      return problem(std::string{row.key}, row.expected(), &*given);
  }
  return {};
}

tl::expected<void, Problem> refuse_others(const json& value, const Kind& kind) {
  const std::vector<std::string_view> keys = keys_of(kind);
  for (const auto& item : value.items()) {
    if (std::ranges::count(keys, item.key()) == 0)
      return tl::unexpected{Problem{.key = json_text::quoted_key(item.key()),
                                    .expected = fmt::format("{}", fmt::join(keys, ", ")),
                                    .is_unknown_key = true}};
  }
  return {};
}

}  // namespace

std::string rule_of(const ArgumentRow& row) {
  if (row.form == Form::Word) return choice_of(row.words);
  if (row.form == Form::Hexadecimal)
    return fmt::format("a number from {:X}h to {:X}h (\"0x{:X}\")", row.low, row.high, row.high);
  if (row.form == Form::Text) return fmt::format("a text of {} to {} characters", row.low, row.high);
  return fmt::format("a whole number from {} to {}", row.low, row.high);
}

std::string Problem::message() const {
  const std::string place = key.empty() ? std::string{} : key + ": ";
  if (is_unknown_key) return fmt::format("{}unknown key, expected one of: {}", place, expected);
  return fmt::format("{}expected {}, got {}", place, expected, got.empty() ? "nothing" : got);
}

tl::expected<Fault, Problem> read_fault(const json& value, std::span<const Kind> kinds) {
  if (!value.is_object()) return problem({}, "an object with a kind", &value);
  const auto kind = kind_in(value, kinds);
  if (!kind) return tl::unexpected{kind.error()};
  Fault fault{.kind = *kind};
  auto read = refuse_others(value, **kind);
  if (read) read = read_arguments(value, fault);
  if (read) read = read_when(value, fault);
  if (!read) return tl::unexpected{std::move(read.error())};
  return fault;
}

tl::expected<Fault, Problem> read_fault_words(std::string_view words, std::span<const Kind> kinds) {
  json value = json::object();
  std::string last;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (word.empty()) continue;
    const std::size_t sign = word.find('=');
    if (!value.contains("kind")) {
      value["kind"] = word;
    } else if (sign != std::string_view::npos) {
      last = word.substr(0, sign);
      value[last] = word.substr(sign + 1);
    } else if (!last.empty()) {
      value[last] = value[last].get<std::string>() + ' ' + std::string{word};  // "until=10 heartbeat"
    } else {
      const json got = word;
      return problem({}, "KIND and KEY=VALUE", &got);
    }
  }
  return read_fault(value, kinds);
}

json json_of(const Fault& fault) {
  json value{{"kind", fault.kind->name}};
  for (const ArgumentUse& use : fault.kind->arguments) {
    const ArgumentRow& row = row_of(use.argument);
    if (const auto argument = fault.value(use.argument)) value[row.key] = argument_json(*argument, row, fault);
  }
  for (const WhenRow& row : when_rows())
    if (json written = row.write(fault.when); !written.is_null()) value[row.key] = std::move(written);
  return value;
}

json json_of(const Trigger& trigger) {
  return {{"state", kPhaseNames[static_cast<std::size_t>(trigger.phase())]},
          {"events", trigger.events()},
          {"opportunities", trigger.opportunities()},
          {"hits", trigger.hits()},
          {"hit_at", trigger.hit_at()}};
}

json json_of(const Kind& kind) {
  json arguments = json::array();
  for (const ArgumentUse& use : kind.arguments) {
    const ArgumentRow& row = row_of(use.argument);
    json argument{
        {"key", row.key}, {"expected", rule_of(row)}, {"summary", row.summary}, {"required", use.absent.empty()}};
    if (!use.absent.empty()) argument["absent"] = use.absent;
    arguments.push_back(std::move(argument));
  }
  return {{"kind", kind.name},
          {"summary", kind.summary},
          {"nature", kNatureNames[static_cast<std::size_t>(kind.nature)]},
          {"event", kEventNames[static_cast<std::size_t>(kind.own)]},
          {"arguments", std::move(arguments)}};
}

std::vector<std::string_view> keys_of(const Kind& kind) {
  std::vector<std::string_view> keys{"kind"};
  for (const ArgumentUse& use : kind.arguments) keys.push_back(row_of(use.argument).key);
  for (const WhenRow& row : when_rows()) keys.push_back(row.key);
  return keys;
}

}  // namespace injection
