#include "trace/export/text_export.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trace {
namespace {

using nlohmann::json;

/// As RFC 4180 has it.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char letter : text) result.append(letter == '"' ? "\"\"" : std::string{letter});
  return result + '"';
}

std::string with_unit(const Result::Signal& signal) {
  return signal.unit.empty() ? signal.name : fmt::format("{} ({})", signal.name, signal.unit);
}

json json_of(const Result::Frame& frame) {
  json item{
      {"t", frame.t}, {"id", frame.id}, {"direction", frame.sent ? "sent" : "received"}, {"data", frame.data}};
  if (frame.extended) item["extended"] = true;
  if (frame.remote) item["remote"] = true;
  return item;
}

json json_of(const Result::Event& event) {
  json item{
      {"t", event.t}, {"kind", event.kind}, {"axis", event.place}, {"active", event.active}, {"text", event.text}};
  if (event.number) item["number"] = *event.number;
  if (event.index) item["index"] = *event.index;
  if (event.value) item["value"] = *event.value;
  return item;
}

template <class Item>
json list_of(const std::vector<Item>& items) {
  json list = json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

}  // namespace

std::string export_csv(const Result& result) {
  std::string text = "t (s)";
  if (result.trigger) text += ",t from trigger (s)";
  for (const Result::Signal& signal : result.signals) text += ',' + quoted(with_unit(signal));
  text += '\n';
  for (const Result::Sample& sample : result.samples) {
    text += fmt::format("{:.9f}", sample.t);
    if (result.trigger) text += fmt::format(",{:.9f}", sample.t - *result.trigger);
    for (const double value : sample.values) text += std::isfinite(value) ? fmt::format(",{}", value) : ",";
    text += '\n';
  }
  return text;
}

std::string export_json(const Result& result) {
  json signals = json::array();
  for (const Result::Signal& signal : result.signals)
    signals.push_back({{"signal", signal.name}, {"unit", signal.unit}, {"text", signal.text}});
  json samples = json::array();
  for (const Result::Sample& sample : result.samples) {
    json row = json::array({sample.t});
    for (const double value : sample.values) row.push_back(value);
    samples.push_back(std::move(row));
  }
  json whole{{"signals", std::move(signals)},
             {"samples", std::move(samples)},
             {"frames", list_of(result.frames)},
             {"events", list_of(result.events)},
             {"lost_frames", result.lost_frames}};
  if (result.trigger) whole["trigger_t"] = *result.trigger;
  return whole.dump(1) + '\n';
}

}  // namespace trace
