#include "daemon/control/trace/trace_view.hpp"

#include <array>
#include <chrono>

#include <fmt/format.h>

#include "daemon/instance/instance.hpp"
#include "trace/trigger_table.hpp"

namespace axisd {
namespace {

using nlohmann::json;

json place_value(trace::Place place) {
  return place == trace::kInfeedPlace ? json("infeed") : json(place);
}

json sample(const Instance& instance, const trace::Recording& result, std::size_t position) {
  json item = json::array();
  item.push_back(seconds_since_start(instance, result.time(position)));
  for (const double value : result.values(position)) item.push_back(value);
  return item;
}

json frame(const Instance& instance, const trace::Frame& frame) {
  std::string data;
  for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) data += fmt::format("{:02X}", frame.data[i]);
  json item{{"t", seconds_since_start(instance, frame.time)},
            {"id", frame.id},
            {"direction", frame.direction == trace::Direction::Sent ? "sent" : "received"},
            {"data", std::move(data)}};
  if (frame.extended) item["extended"] = true;
  if (frame.remote) item["remote"] = true;
  return item;
}

json event(const Instance& instance, const trace::Event& event) {
  json item{{"t", seconds_since_start(instance, event.time)},
            {"kind", event.kind},
            {"axis", place_value(event.place)},
            {"active", event.active},
            {"text", event.text}};
  if (event.number != 0) {
    item["number"] = event.number;
    if (event.value) item["index"] = event.index;
  }
  if (event.value) item["value"] = *event.value;
  return item;
}

json result_summary(const Instance& instance, const trace::Recording& result) {
  json summary{{"result", result.number()},
               {"samples", result.size()},
               {"frames", result.frames().size()},
               {"events", result.events().size()},
               {"lost_frames", result.frames().lost()},
               {"lost_events", result.events().lost()}};
  if (result.size() > 0) {
    summary["from_t"] = seconds_since_start(instance, result.time(0));
    summary["to_t"] = seconds_since_start(instance, result.time(result.size() - 1));
  }
  if (result.trigger_time()) summary["trigger_t"] = seconds_since_start(instance, *result.trigger_time());
  return summary;
}

}  // namespace

control::Error error_of(const trace::Problem& problem) {
  constexpr std::array kCodes{control::ErrorCode::BadParameter, control::ErrorCode::NotFound,
                              control::ErrorCode::Overflow};
  return {kCodes[static_cast<std::size_t>(problem.kind)],
          fmt::format("{}: expected {}", problem.key, problem.expected)};
}

double seconds_since_start(const Instance& instance, unit::TimePoint time) noexcept {
  return std::chrono::duration<double>{time - device::unit_time(instance.started())}.count();
}

std::size_t part_size(const trace::Recording& result, std::size_t part) noexcept {
  const std::array sizes{result.size(), result.frames().size(), result.events().size()};
  return sizes[part];
}

json part_item(const Instance& instance, const trace::Recording& result, std::size_t part, std::size_t position) {
  if (part == 0) return sample(instance, result, position);
  return part == 1 ? frame(instance, result.frames()[position]) : event(instance, result.events()[position]);
}

json traced_signals(const Instance& instance) {
  json signals = json::array();
  for (const trace::Signal& signal : instance.trace().tracer().signals())
    signals.push_back({{"signal", signal.name}, {"unit", signal.unit}, {"text", signal.text}});
  return signals;
}

json trace_status(const Instance& instance) {
  const trace::Tracer& tracer = instance.trace().tracer();
  json status{{"phase", name_of(tracer.phase())}};
  if (tracer.phase() == trace::Phase::Off) return status;
  const trace::Settings& settings = tracer.settings();
  status["signals"] = traced_signals(instance);
  status["trigger"] = row_of(settings.trigger.kind).name;
  status["repeat"] = settings.repeat;
  status["every"] = settings.every == trace::kEveryCycle
                        ? json("cycle")
                        : json(std::chrono::duration<double>{settings.every}.count());
  if (const trace::Recording* const current = tracer.current()) status["recorded"] = current->size();
  json results = json::array();
  const trace::Tracer::Results there = tracer.results();
  for (std::uint64_t number = there.first; number <= there.last; ++number)
    results.push_back(result_summary(instance, *tracer.result(number)));
  status["results"] = std::move(results);
  return status;
}

}  // namespace axisd
