#include "trace/export/curve.hpp"

#include <algorithm>
#include <cmath>

#include "trace/export/svg_writer.hpp"

namespace trace {
namespace {

/// Points of one column of pixels: no more than the first, the lowest, the highest and the last are drawn.
struct Column {
  double first_x = 0.0;
  double last_x = 0.0;
  double first = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  double last = 0.0;
  std::size_t points = 0;

  void take(double x, double y) noexcept {
    if (points++ == 0) {
      first_x = x;
      first = lowest = highest = y;
    }
    last_x = x;
    last = y;
    lowest = std::min(lowest, y);
    highest = std::max(highest, y);
  }
};

class CurveWriter {
 public:
  void take(double x, double y) {
    if (column_.points > 0 && std::floor(x) != std::floor(column_.first_x)) put_column();
    column_.take(x, y);
  }
  void interrupt() {
    put_column();
    end_level();
    starts_ = true;
  }
  std::string data() && {
    put_column();
    end_level();
    return std::move(data_);
  }

 private:
  void put_column() {
    if (column_.points == 0) return;
    const double middle = 0.5 * (column_.first_x + column_.last_x);
    put(column_.first_x, column_.first);
    if (column_.lowest < std::min(column_.first, column_.last)) put(middle, column_.lowest);
    if (column_.highest > std::max(column_.first, column_.last)) put(middle, column_.highest);
    if (column_.points > 1) put(column_.last_x, column_.last);
    column_ = {};
  }
  /// Of a level line its two ends.
  void put(double x, double y) {
    const std::string height = coordinate(y);
    if (!starts_ && height == height_) {
      level_end_ = coordinate(x);
      return;
    }
    end_level();
    data_.append(starts_ ? "M" : "L").append(coordinate(x)).append(",").append(height);
    height_ = height;
    starts_ = false;
  }
  void end_level() {
    if (!level_end_.empty()) data_.append("H").append(level_end_);
    level_end_.clear();
  }

  std::string height_;     ///< of the point that was put last
  std::string level_end_;  ///< how far it reaches, if further than that
  std::string data_;
  Column column_;
  bool starts_ = true;
};

}  // namespace

double sample_interval(const Result& result) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < result.samples.size(); ++i)
    intervals.push_back(result.samples[i].t - result.samples[i - 1].t);
  if (intervals.empty()) return 0.0;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

std::string curve_of(const Result& result, std::size_t signal, const Scale& time, const Scale& values) {
  constexpr double kGap = 1.5;  // of the usual time between samples
  const double longest = kGap * sample_interval(result);
  CurveWriter writer;
  double before = result.samples.empty() ? 0.0 : result.samples.front().t;
  for (const Result::Sample& sample : result.samples) {
    if (sample.t - before > longest || !std::isfinite(sample.values[signal])) writer.interrupt();
    before = sample.t;
    if (std::isfinite(sample.values[signal]))
      writer.take(time.place(sample.t), values.place(sample.values[signal]));
  }
  return std::move(writer).data();
}

}  // namespace trace
