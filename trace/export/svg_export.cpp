#include "trace/export/svg_export.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "trace/export/curve.hpp"
#include "trace/export/lanes.hpp"
#include "trace/export/svg_writer.hpp"

namespace trace {
namespace {

constexpr double kWidth = 1200.0;
constexpr double kUnitPlace = 16.0;  // reads upwards
constexpr double kLeft = 90.0;
constexpr double kRight = kWidth - 20.0;
constexpr double kTitleHeight = 30.0;
constexpr double kEventRow = 15.0;
constexpr double kFrameRow = 18.0;
constexpr double kAxisHeight = 44.0;
constexpr int kTimeTicks = 10;
constexpr int kValueTicks = 5;
constexpr double kShortestSpan = 1e-6;  // s

constexpr std::string_view kGrid = R"(stroke="#e4e4e4")";
constexpr std::string_view kFrame = R"(fill="none" stroke="#909090")";
constexpr std::string_view kTriggerLine = R"(stroke="#c00000" stroke-width="1.5")";
constexpr std::string_view kSmall = R"(font-size="11" fill="#404040")";

/// How times are shown: since what, and in which unit.
struct TimeUnit {
  const char* text;
  double seconds;
};

TimeUnit unit_for(double span) noexcept {
  constexpr double kSeconds = 2.0, kMilliseconds = 2e-3;
  if (span >= kSeconds) return {"s", 1.0};
  return span >= kMilliseconds ? TimeUnit{"ms", 1e-3} : TimeUnit{"µs", 1e-6};
}

Scale time_scale(const Result& result) {
  double low = result.samples.empty() ? result.trigger.value_or(0.0) : result.samples.front().t;
  double high = result.samples.empty() ? low : result.samples.back().t;
  if (result.trigger) low = std::min(low, *result.trigger);
  if (result.trigger) high = std::max(high, *result.trigger);
  return {low, std::max(high, low + kShortestSpan), kLeft, kRight};
}

/// Draws a picture from top to bottom.
class Picture {
 public:
  explicit Picture(const Result& result)
      : result_{result},
        time_{time_scale(result)},
        lanes_{lanes_of(result, kTitleHeight)},
        labels_{event_labels(result, time_, kRight)},
        events_top_{lanes_.empty() ? kTitleHeight : lanes_.back().top + lanes_.back().height + 10.0},
        frames_top_{events_top_ + kEventRow * event_rows() + (labels_.empty() ? 0.0 : 8.0)},
        bottom_{frames_top_ + (result.frames.empty() ? 0.0 : 2.0 * kFrameRow + 6.0)},
        svg_{kWidth, bottom_ + kAxisHeight} {}

  std::string draw() && {
    title();
    time_axis();
    for (const Lane& lane : lanes_) draw(lane);
    events();
    frames();
    if (result_.trigger) upright(time_.place(*result_.trigger), kTriggerLine);
    return std::move(svg_).picture();
  }

 private:
  double event_rows() const {
    int rows = 0;
    for (const EventLabel& label : labels_) rows = std::max(rows, label.row + 1);
    return rows;
  }

  /// A line through all lanes, but not through the names above them.
  void upright(double x, std::string_view style) {
    for (const Lane& lane : lanes_) svg_.line(x, lane.top, x, lane.top + lane.height, style);
    svg_.line(x, events_top_, x, bottom_, style);
  }

  void title() {
    std::string text = fmt::format("{} samples", result_.samples.size());
    if (result_.samples.size() > 1) text += fmt::format(" every {:g} ms", 1e3 * sample_interval(result_));
    if (result_.trigger) text += fmt::format(", trigger {:.6f} s after the start of the unit", *result_.trigger);
    if (result_.lost_frames > 0) text += fmt::format(", {} frames lost", result_.lost_frames);
    svg_.text(kLeft, 18.0, text, Anchor::Start, kSmall);
  }

  void time_axis() {
    const TimeUnit unit = unit_for(time_.high() - time_.low());
    const double zero = result_.trigger.value_or(time_.low());
    const Scale shown{(time_.low() - zero) / unit.seconds, (time_.high() - zero) / unit.seconds, kLeft, kRight};
    const double step = round_step(shown.high() - shown.low(), kTimeTicks);
    for (const double tick : shown.ticks(kTimeTicks)) {
      const double x = shown.place(tick);
      upright(x, kGrid);
      svg_.line(x, bottom_, x, bottom_ + 4.0, R"(stroke="#606060")");
      svg_.text(x, bottom_ + 17.0, tick_text(tick, step), Anchor::Middle, kSmall);
    }
    svg_.line(kLeft, bottom_, kRight, bottom_, R"(stroke="#606060")");
    svg_.text(0.5 * (kLeft + kRight), bottom_ + 35.0,
              fmt::format("time from the {} ({})", result_.trigger ? "trigger" : "first sample", unit.text),
              Anchor::Middle, kSmall);
  }

  void draw(const Lane& lane) {
    svg_.rectangle(kLeft, lane.top, kRight - kLeft, lane.height, kFrame);
    if (!lane.is_bit) value_axis(lane);
    double x = kLeft;
    for (const std::size_t signal : lane.signals) {
      const Result::Signal& named = result_.signals[signal];
      const std::string text = fmt::format("{}  {}", named.name, named.text);
      svg_.rectangle(x, lane.top - 13.0, 10.0, 10.0, fmt::format(R"(fill="{}")", colour_of(signal)));
      svg_.text(x + 14.0, lane.top - 4.0, lane.signals.size() > 3 ? named.name : text, Anchor::Start, kSmall);
      x += 34.0 + 6.0 * static_cast<double>((lane.signals.size() > 3 ? named.name : text).size());
      svg_.path(
          curve_of(result_, signal, time_, lane.values),
          fmt::format(R"(fill="none" stroke="{}" stroke-width="1.3" stroke-linejoin="round")", colour_of(signal)));
    }
  }

  void value_axis(const Lane& lane) {
    const double step = round_step(lane.values.high() - lane.values.low(), kValueTicks);
    for (const double tick : lane.values.ticks(kValueTicks)) {
      const double y = lane.values.place(tick);
      svg_.line(kLeft, y, kRight, y, kGrid);
      svg_.line(kLeft - 4.0, y, kLeft, y, R"(stroke="#606060")");
      svg_.text(kLeft - 7.0, y + 4.0, tick_text(tick, step), Anchor::End, kSmall);
    }
    const double middle = lane.top + 0.5 * lane.height;
    svg_.text(kUnitPlace, middle, lane.unit, Anchor::Middle,
              fmt::format(R"x(transform="rotate(-90 {:.1f} {:.1f})")x", kUnitPlace, middle));
  }

  void events() {
    if (labels_.empty()) return;
    svg_.text(kLeft - 7.0, events_top_ + 11.0, "events", Anchor::End, kSmall);
    for (const EventLabel& label : labels_) {
      const std::string_view colour = colour_of(result_.events[label.event]);
      upright(label.x, fmt::format(R"(stroke="{}" stroke-dasharray="3,3" stroke-opacity="0.7")", colour));
      if (label.row == kNoRow) continue;
      const double y = events_top_ + kEventRow * label.row + 11.0;
      svg_.text(label.before ? label.x - 3.0 : label.x + 3.0, y, label.text,
                label.before ? Anchor::End : Anchor::Start, fmt::format(R"(font-size="11" fill="{}")", colour));
    }
  }

  void frames() {
    if (result_.frames.empty()) return;
    for (const bool sent : {false, true}) {
      const double top = frames_top_ + (sent ? kFrameRow : 0.0);
      svg_.text(kLeft - 7.0, top + 12.0, sent ? "sent" : "received", Anchor::End, kSmall);
      std::string marks;
      double before = kLeft - 1.0;
      for (const Result::Frame& frame : result_.frames) {
        const double x = std::round(2.0 * time_.place(frame.t)) / 2.0;
        const bool is_seen = frame.sent == sent && x > before && x <= kRight;
        if (!is_seen) continue;
        marks.append("M").append(coordinate(x)).append(",").append(coordinate(top + 2.0)).append("v12");
        before = x;
      }
      svg_.path(marks, sent ? R"(stroke="#1f4e9c")" : R"(stroke="#404040")");
    }
  }

  const Result& result_;
  Scale time_;
  std::vector<Lane> lanes_;
  std::vector<EventLabel> labels_;
  double events_top_;
  double frames_top_;
  double bottom_;
  SvgWriter svg_;
};

}  // namespace

std::string export_svg(const Result& result) {
  return Picture{result}.draw();
}

}  // namespace trace
