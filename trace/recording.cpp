#include "trace/recording.hpp"

#include <algorithm>

namespace trace {

void Recording::begin(std::uint64_t number) noexcept {
  number_ = number;
  first_ = count_ = 0;
  dropped_ = false;
  triggered_.reset();
  frames_.clear();
  events_.clear();
}

void Recording::trigger(unit::TimePoint time) noexcept {
  triggered_ = time;
  while (count_ > size_.before) drop_oldest();
  remaining_ = size_.samples - size_.before;
}

void Recording::sample(unit::TimePoint time, std::span<const Reader> readers) noexcept {
  if (is_full()) return;
  if (count_ == size_.samples) drop_oldest();
  const std::size_t place = slot(count_++);
  times_[place] = time;
  std::ranges::transform(readers, values_.begin() + static_cast<std::ptrdiff_t>(place * size_.signals),
                         [](const Reader& reader) { return reader.value(); });
  if (triggered_) --remaining_;
}

void Recording::end() noexcept {
  if (!dropped_) return;
  unit::TimePoint start = triggered_.value_or(unit::kNever);
  if (count_ > 0) start = std::min(start, time(0));
  frames_.forget_before(start);
  events_.forget_before(start);
}

}  // namespace trace
