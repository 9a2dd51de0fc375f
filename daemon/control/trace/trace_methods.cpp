#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "daemon/control/arguments.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/control/trace/trace_view.hpp"
#include "daemon/instance/instance.hpp"
#include "trace/json/settings_reader.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Items of a page: a line of the protocol has room for so many samples of eight signals.
constexpr std::int64_t kMostItems = 200;
constexpr std::int64_t kLastItem = 10'000'000;
constexpr std::int64_t kMostResults = 1'000'000'000;

Outcome start_trace(const Call& call, const json& params) {
  if (call.instance.trace().tracer().is_on())
    return refuse(control::ErrorCode::Busy, "a trace is on: trace.stop ends it");
  const auto settings = trace::read_settings(params);
  if (!settings) return tl::unexpected{error_of(settings.error())};
  if (const auto started = call.instance.trace().start(*settings); !started)
    return tl::unexpected{error_of(started.error())};
  return trace_status(call.instance);
}

Outcome stop_trace(const Call& call, const json&) {
  call.instance.trace().stop();
  return trace_status(call.instance);
}

Outcome show_status(const Call& call, const json&) {
  return trace_status(call.instance);
}

/// The result that "result" of @p arguments names, the latest without.
Taken<const trace::Recording*> result_of(const trace::Tracer& tracer, const Arguments& arguments) {
  const trace::Tracer::Results there = tracer.results();
  if (there.last == 0)
    return tl::unexpected{
        control::Error{control::ErrorCode::NotFound,
                       fmt::format("there is no result yet: the trace is {}", name_of(tracer.phase()))}};
  const auto number = arguments.integer("result", 1, kMostResults, static_cast<std::int64_t>(there.last));
  if (!number) return tl::unexpected{number.error()};
  const trace::Recording* const result = tracer.result(static_cast<std::uint64_t>(*number));
  if (result != nullptr) return result;
  return tl::unexpected{
      control::Error{control::ErrorCode::NotFound,
                     fmt::format("result: expected {} to {}, got {}", there.first, there.last, *number)}};
}

Outcome read_trace(const Call& call, const json& params) {
  const Arguments arguments{params};
  const auto result = result_of(call.instance.trace().tracer(), arguments);
  if (!result) return tl::unexpected{result.error()};
  const auto part = arguments.choice("part", kTraceParts, 0);
  if (!part) return tl::unexpected{part.error()};
  const auto asked = arguments.page({.last = kLastItem, .most = kMostItems, .usual = kMostItems});
  if (!asked) return tl::unexpected{asked.error()};
  const std::size_t total = part_size(**result, *part);
  const std::size_t first = std::min(asked->from, total);
  const std::size_t last = std::min(first + asked->count, total);
  json items = json::array();
  for (std::size_t i = first; i < last; ++i) items.push_back(part_item(call.instance, **result, *part, i));
  json page{{"result", (*result)->number()},
            {"signals", traced_signals(call.instance)},
            {"part", kTraceParts[*part]},
            {"from", first},
            {"total", total},
            {"lost_frames", (*result)->frames().lost()},
            {"items", std::move(items)}};
  if ((*result)->trigger_time())
    page["trigger_t"] = seconds_since_start(call.instance, *(*result)->trigger_time());
  if (last < total) page["next"] = last;
  return page;
}

constexpr std::array kTraceHandlers{
    Handler{"trace.start", &start_trace},
    Handler{"trace.stop", &stop_trace},
    Handler{"trace.status", &show_status},
    Handler{"trace.read", &read_trace},
};

}  // namespace

std::span<const Handler> trace_handlers() noexcept {
  return kTraceHandlers;
}

}  // namespace axisd
