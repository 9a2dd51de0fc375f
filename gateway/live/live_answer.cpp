#include "gateway/live/live_answer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gateway {
namespace {

using nlohmann::json;

/// The daemon makes a line of the samples of so many milliseconds.
constexpr int kBatch = 50;

tl::unexpected<Error> bad(std::string message) {
  return tl::unexpected{refuse(Refused::BadRequest, std::move(message))};
}

/// The number of the line of @p feed after which is asked for; nothing if @p after is not in this feed.
std::optional<std::uint64_t> line_in(const Positioned& feed, const Cursor& after) {
  const auto position = std::ranges::find(after, feed.number, &FeedPosition::feed);
  const bool is_in = position != after.end() && position->line <= feed.lines->last();
  return is_in ? std::optional{position->line} : std::nullopt;
}

}  // namespace

tl::expected<LiveRequest, Error> live_request(const std::string& unit, const json& params) {
  LiveRequest request;
  const json frames = params.value("frames", json(false));
  if (!frames.is_boolean()) return bad("frames: expected true or false");
  if (params.contains("period_ms") && !params.contains("signals"))
    return bad("signals: has to be there with period_ms");
  if (frames == false && !params.contains("signals"))
    return bad("expected signals with period_ms, or frames=true, or both");
  if (frames == true) request.frames = {{"unit", unit}};
  if (params.contains("signals")) {
    request.samples = {{"unit", unit}, {"signals", params["signals"]}, {"batch_ms", kBatch}};
    if (params.contains("period_ms")) request.samples["period_ms"] = params["period_ms"];
  }
  if (!params.contains("after")) return request;
  request.after = parse_cursor(params["after"].get_ref<const std::string&>());
  if (!request.after) return bad("after: expected the cursor of an answer before");
  return request;
}

Response live_answer(std::span<const Positioned> feeds, const std::optional<Cursor>& after) {
  std::string lists;
  Cursor present;
  std::uint64_t lost = 0;
  bool is_restarted = false;
  for (const std::string_view name : {"samples", "frames"})
    if (std::ranges::find(feeds, name, &Positioned::name) == feeds.end())
      lists.append(",\"").append(name).append("\":[]");
  for (const Positioned& feed : feeds) {
    present.push_back({feed.number, feed.lines->last()});
    const auto line = after ? line_in(feed, *after) : std::nullopt;
    is_restarted = is_restarted || (after && !line);
    lists.append(",\"").append(feed.name).append("\":[");
    lost += feed.lines->copy_behind(line.value_or(feed.lines->last()), lists);
    lists += ']';
  }
  lists += fmt::format(",\"lost\":{},\"restarted\":{}}}\n", lost, is_restarted);
  lists.insert(0, fmt::format("{{\"cursor\":\"{}\"", text_of(present)));
  return {.body = std::move(lists)};
}

}  // namespace gateway
