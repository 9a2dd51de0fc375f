#include "trace/export/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace trace {
namespace {

constexpr double kLaneHeight = 170.0;
constexpr double kBitHeight = 26.0;
constexpr double kLaneGap = 12.0;
constexpr double kLetterWidth = 6.2;
constexpr int kMostRows = 6;

/// Whether signal @p signal is nothing but 0 and 1.
bool is_bit(const Result& result, std::size_t signal) {
  return result.signals[signal].unit.empty() && !result.samples.empty() &&
         std::ranges::all_of(result.samples, [signal](const Result::Sample& sample) {
           return sample.values[signal] == 0.0 || sample.values[signal] == 1.0;
         });
}

Scale scale_of(const Result& result, const Lane& lane) {
  const double bottom = lane.top + lane.height;
  if (lane.is_bit) return {0.0, 1.0, bottom - 3.0, lane.top + 3.0};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Result::Sample& sample : result.samples) {
    for (const std::size_t signal : lane.signals) {
      if (!std::isfinite(sample.values[signal])) continue;
      low = std::min(low, sample.values[signal]);
      high = std::max(high, sample.values[signal]);
    }
  }
  return Scale::around(low, high, bottom, lane.top);
}

struct KindRow {
  std::string_view kind;
  std::string_view colour;
};
constexpr std::string_view kOtherColour = "#606060";
constexpr std::array kKinds{KindRow{"fault", "#c00000"}, KindRow{"alarm", "#b36b00"},
                            KindRow{"drive-state", "#1f4e9c"}, KindRow{"nmt", "#00707a"},
                            KindRow{"parameter", "#5a2d8c"}};

}  // namespace

std::vector<Lane> lanes_of(const Result& result, double top) {
  std::vector<Lane> lanes;
  for (std::size_t i = 0; i < result.signals.size(); ++i) {
    const bool bit = is_bit(result, i);
    const auto same = std::ranges::find_if(
        lanes, [&](const Lane& lane) { return !bit && !lane.is_bit && lane.unit == result.signals[i].unit; });
    if (same != lanes.end())
      same->signals.push_back(i);
    else
      lanes.push_back({.unit = result.signals[i].unit, .signals = {i}, .is_bit = bit});
  }
  for (Lane& lane : lanes) {
    lane.top = top + kNameHeight;
    lane.height = lane.is_bit ? kBitHeight : kLaneHeight;
    lane.values = scale_of(result, lane);
    top = lane.top + lane.height + kLaneGap;
  }
  return lanes;
}

std::string_view colour_of(std::size_t signal) noexcept {
  constexpr std::array<std::string_view, 8> kColours{"#0072b2", "#d55e00", "#009e73", "#aa4499",
                                                     "#8c6d00", "#3ba3d0", "#303030", "#882255"};
  return kColours[signal % kColours.size()];
}

std::string event_text(const Result::Event& event) {
  const std::string place = event.place == "0" ? "" : event.place == "infeed" ? "infeed" : "axis " + event.place;
  const auto with_place = [&](const std::string& text) { return place.empty() ? text : place + ' ' + text; };
  const char* const gone = event.active ? "" : " gone";
  if (event.kind == "fault" || event.kind == "alarm")
    return with_place(fmt::format("{}{:05}{}", event.kind == "fault" ? 'F' : 'A', event.number.value_or(0), gone));
  if (event.kind == "parameter" && event.number) {
    std::string text = fmt::format("p{:04}", *event.number);
    if (event.index.value_or(0) > 0) text += fmt::format("[{}]", *event.index);
    if (event.value) text += fmt::format(" = {:g}", *event.value);
    return with_place(text);
  }
  if (event.kind == "drive-state") return with_place(event.text);
  return with_place(fmt::format("{} {}{}", event.kind, event.text, gone));
}

std::string_view colour_of(const Result::Event& event) noexcept {
  const auto* const row = std::ranges::find(kKinds, event.kind, &KindRow::kind);
  return row != kKinds.end() ? row->colour : kOtherColour;
}

std::vector<EventLabel> event_labels(const Result& result, const Scale& time, double right) {
  std::vector<EventLabel> labels;
  std::array<double, kMostRows> ends{};
  for (std::size_t i = 0; i < result.events.size(); ++i) {
    const Result::Event& event = result.events[i];
    if (event.t < time.low() || event.t > time.high()) continue;
    EventLabel label{
        .event = i, .x = time.place(event.t), .row = kNoRow, .text = event_text(event), .before = false};
    const double width = kLetterWidth * static_cast<double>(label.text.size() + 1);
    label.before = label.x + width > right;
    const double begin = label.before ? label.x - width : label.x;
    const auto* const row = std::ranges::find_if(ends, [begin](double end) { return end <= begin; });
    if (row != ends.end()) {
      label.row = static_cast<int>(row - ends.begin());
      ends[static_cast<std::size_t>(label.row)] = begin + width;
    }
    labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace trace
