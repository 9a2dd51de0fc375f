#include "tools/axisctl/runs/fidelity/time_map.hpp"

#include <algorithm>

namespace runs {
namespace {

canopen::Duration scaled(canopen::Duration time, double factor) noexcept {
  return std::chrono::duration_cast<canopen::Duration>(std::chrono::duration<double, std::nano>{time} * factor);
}

}  // namespace

TimeMap::TimeMap(const Course& here, const Course& there, const Yardstick& yardstick, double pace)
    : yardstick_{yardstick}, pace_{pace} {
  auto next = there.passages.begin();
  for (const Passage& passage : here.passages) {
    if (!passage.is_of_master) continue;
    next = std::find_if(next, there.passages.end(), [](const Passage& other) { return other.is_of_master; });
    if (next == there.passages.end()) break;
    const canopen::Duration before = marks_.empty() ? passage.at : marks_.back().here;
    marks_.push_back({std::max(before, passage.at), next->at});
    ++next;
  }
  if (marks_.empty()) marks_.push_back({});
}

const TimeMap::Mark& TimeMap::mark_before(canopen::Duration at) const {
  const auto behind = std::ranges::upper_bound(marks_, at, {}, &Mark::here);
  return behind == marks_.begin() ? marks_.front() : *std::prev(behind);
}

canopen::Duration TimeMap::there(canopen::Duration at) const {
  const Mark& mark = mark_before(at);
  return mark.there + length_there(at - mark.here);
}

canopen::Duration TimeMap::length_there(canopen::Duration time) const noexcept {
  return pace_ == 1.0 ? time : scaled(time, pace_);
}

canopen::Duration TimeMap::band(canopen::Duration at) const {
  return yardstick_.time + scaled(at - mark_before(at).here, yardstick_.time_share);
}

}  // namespace runs
