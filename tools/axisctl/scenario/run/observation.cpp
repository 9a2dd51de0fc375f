#include "tools/axisctl/scenario/run/observation.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "json/strict.hpp"
#include "tools/axisctl/scenario/run/fault_load.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace scenario {
namespace {

using nlohmann::json;
using Answer = tl::expected<bool, std::string>;

/// What a row of conditions() looks at; puts what it has seen into @p found.
using Look = Answer (*)(Context& context, const json& keys, std::string& found);

/// "Operation enabled" as a word: operation-enabled.
std::string word_of(const json& state) {
  std::string word = state.is_string() ? state.get<std::string>() : "";
  std::ranges::transform(word, word.begin(), [](char c) {
    return c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return word;
}

tl::expected<json, std::string> status_of(Context& context, const json& keys) {
  return ask(context.stations.unit(keys), "status");
}

/// A unit that is off has no state: @p found says so, and nothing holds.
Answer refused(const std::string& message, std::string& found) {
  found = message;
  return false;
}

Answer look_at_state(Context& context, const json& keys, const char* key, const json::json_pointer& place,
                     std::string& found) {
  const auto status = status_of(context, keys);
  if (!status) return refused(status.error(), found);
  found = word_of(status->value(place, json{}));
  return found == keys.at(key);
}

Answer look_at_nmt(Context& context, const json& keys, std::string& found) {
  return look_at_state(context, keys, "nmt_state", "/nmt_state"_json_pointer, found);
}
Answer look_at_bus(Context& context, const json& keys, std::string& found) {
  return look_at_state(context, keys, "bus_state", "/bus/state"_json_pointer, found);
}
json::json_pointer axis_of(const json& keys) {
  return json::json_pointer{fmt::format("/axes/{}", keys.value("axis", 1) - 1)};
}
Answer look_at_drive(Context& context, const json& keys, std::string& found) {
  return look_at_state(context, keys, "drive_state", axis_of(keys) / "state", found);
}

Answer look_at_faults(Context& context, const json& keys, std::string& found) {
  const auto status = status_of(context, keys);
  if (!status) return refused(status.error(), found);
  const json faults = status->value(axis_of(keys) / "faults", json::array());
  found.clear();
  bool is_there = false;
  for (const json& fault : faults) {
    const int number = fault.value("number", 0);
    found += fmt::format("{}F{:05}", found.empty() ? "" : " ", number);
    is_there = is_there || (keys.contains("fault") && number == keys.at("fault").get<int>());
  }
  if (found.empty()) found = "no fault";
  return keys.contains("no_fault") ? faults.empty() == keys.at("no_fault").get<bool>() : is_there;
}

Answer look_at_signal(Context& context, const json& keys, std::string& found) {
  const auto answer =
      ask(context.stations.unit(keys), "signal.read", {{"signals", json::array({keys.at("signal")})}});
  if (!answer) return refused(answer.error(), found);
  const json value = answer->value("/signals/0/value"_json_pointer, json{});
  found = json_text::quote(value);
  return is_wanted(value, keys);
}

Answer look_at_hits(Context& context, const json& keys, std::string& found) {
  const auto state = state_of_fault(context, keys.at("hits"));
  if (!state) return tl::unexpected{state.error()};
  const json hits = state->value("hits", json{});
  found = fmt::format("{} hits of {} opportunities", hits.dump(), state->value("opportunities", json{}).dump());
  return is_wanted(hits, keys);
}

Answer look_at_end(Context& context, const json& keys, std::string& found) {
  const Program& program = context.stations.program(keys.at("ended"));
  if (!program.process) return refused("not started", found);
  const auto status = program.process->ended();
  if (!status) return refused("it runs", found);
  found = fmt::format("exit status {}", *status);
  if (keys.contains("exit_status") && keys.at("exit_status") != *status) {
    const std::string line = program.process->last_line();
    return tl::unexpected{line.empty() ? found : fmt::format("{}: {}", found, line)};
  }
  return true;
}

struct ConditionRow {
  std::string_view key;
  Look look;
};
constexpr std::array kConditionRows{
    ConditionRow{"nmt_state", look_at_nmt},   ConditionRow{"drive_state", look_at_drive},
    ConditionRow{"signal", look_at_signal},   ConditionRow{"fault", look_at_faults},
    ConditionRow{"no_fault", look_at_faults}, ConditionRow{"bus_state", look_at_bus},
    ConditionRow{"hits", look_at_hits},       ConditionRow{"ended", look_at_end}};

}  // namespace

bool is_wanted(const json& value, const json& keys) {
  const auto number = [&value](double absent) { return value.is_number() ? value.get<double>() : absent; };
  if (keys.contains("is") && keys.at("is") != value) return false;
  if (keys.contains("at_least") && !(value.is_number() && number(0) >= keys.at("at_least").get<double>()))
    return false;
  return !keys.contains("at_most") || (value.is_number() && number(0) <= keys.at("at_most").get<double>());
}

Observation::Observation(Condition condition, std::size_t mark) : condition_{std::move(condition)}, next_{mark} {
  const json& keys = condition_.keys;
  if (!keys.contains("frame")) return;
  pattern_ = *parse_pattern(keys.at("frame").get<std::string>());
  wanted_ = keys.value("count", std::size_t{1});
  if (!keys.contains("mask")) return;
  const Bytes mask = *parse_bytes(keys.at("mask").get<std::string>());
  for (std::size_t i = 0; i < pattern_.mask.size(); ++i)
    pattern_.mask[i] = i < mask.length ? pattern_.mask[i] & mask.data[i] : std::uint8_t{0};
}

bool Observation::look_at_frames(Context& context) {
  const auto& frames = context.bench.frames();
  for (; next_ < frames.size() && count_ < wanted_; ++next_) {
    const TimedFrame& frame = frames[next_];
    if (frame.sent || !pattern_.fits(frame.frame)) continue;
    ++count_;
    behind_ = next_ + 1;
    found_ = conformance::to_text(frame.frame);
  }
  if (count_ == 0) found_ = "none";
  if (wanted_ > 1) found_ = fmt::format("{} of them", count_);
  return count_ >= wanted_;
}

Answer Observation::holds(Context& context) {
  const std::string_view key = condition_.row->key.key;
  if (key == "frame") return look_at_frames(context);
  return std::ranges::find(kConditionRows, key, &ConditionRow::key)->look(context, condition_.keys, found_);
}

}  // namespace scenario
