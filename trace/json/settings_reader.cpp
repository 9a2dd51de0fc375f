#include "trace/json/settings_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "trace/json/fields.hpp"
#include "trace/json/trigger_reader.hpp"

namespace trace {
namespace {

using nlohmann::json;

constexpr double kLongest = 86400.0;  // s
constexpr std::array<std::string_view, 8> kKeys{"signals",  "every",   "trigger", "before_s",
                                                "length_s", "samples", "repeat",  "keep"};

unit::Duration duration_of(double seconds) noexcept {
  return unit::Duration{std::llround(seconds * 1e9)};
}

void read_signals(const Fields& fields, Settings& settings) {
  const json* const list = fields.find("signals");
  const std::string expected = fmt::format("a list of 1 to {} names of signals", kMostSignals);
  if (list != nullptr && list->is_string()) {
    settings.signals.push_back(list->get<std::string>());
    return;
  }
  const bool is_list = list != nullptr && list->is_array() && !list->empty() && list->size() <= kMostSignals;
  if (!is_list) return fields.fail("signals", expected);
  for (const json& name : *list) {
    if (!name.is_string()) return fields.fail("signals", expected);
    settings.signals.push_back(name.get<std::string>());
  }
}

void read_every(const Fields& fields, Settings& settings) {
  const json* const every = fields.find("every");
  if (every == nullptr) return;
  if (*every == "cycle") {
    settings.every = kEveryCycle;
    return;
  }
  // The steps are counted, for 0.000125 is no binary fraction.
  const double steps = every->is_number() ? every->get<double>() * 1e9 / static_cast<double>(kStep.count()) : 0.0;
  const bool is_multiple = steps >= 0.5 && steps < 1e6 && std::abs(steps - std::round(steps)) < 1e-6;
  if (!is_multiple) return fields.fail("every", "a multiple of 0.000125 s, or \"cycle\"");
  settings.every = std::llround(steps) * kStep;
}

void read_length(const Fields& fields, Settings& settings) {
  if (fields.has("before_s"))
    if (const auto before = fields.number("before_s", 0.0, kLongest)) settings.before = duration_of(*before);
  if (fields.has("samples") && fields.has("length_s"))
    return fields.fail("samples", "either `samples` or `length_s`");
  if (fields.has("length_s"))
    if (const auto length = fields.number("length_s", 0.0, kLongest)) settings.length = duration_of(*length);
  if (fields.has("samples"))
    if (const auto samples = fields.integer("samples", 1, kMostValues)) settings.samples = *samples;
}

}  // namespace

std::span<const std::string_view> settings_keys() noexcept {
  return kKeys;
}

tl::expected<Settings, Problem> read_settings(const json& value) {
  std::optional<Problem> problem;
  const Fields fields{value, {}, problem};
  if (!value.is_object()) return tl::unexpected{Problem{Problem::Kind::Malformed, "trace", "an object"}};
  fields.expect_keys(kKeys);
  Settings settings;
  read_signals(fields, settings);
  read_every(fields, settings);
  if (const json* const trigger = fields.find("trigger")) settings.trigger = read_trigger(*trigger, problem);
  read_length(fields, settings);
  if (fields.has("repeat")) settings.repeat = fields.flag("repeat").value_or(false);
  if (fields.has("keep")) settings.keep = fields.integer("keep", 1, kMostKept).value_or(1);
  if (problem) return tl::unexpected{std::move(*problem)};
  return settings;
}

}  // namespace trace
