#include "can/hub/medium/origins.hpp"

#include <algorithm>

#include <sys/random.h>

namespace hub {

namespace {

std::uint32_t random_number() noexcept {
  std::uint32_t number = 0;
  while (number == 0 && getrandom(&number, sizeof number, 0) == sizeof number) continue;
  return number;
}

}  // namespace

Origins::Origins() noexcept : self_{random_number()} {}

bus::Mark Origins::make() noexcept {
  number_ = (number_ + 1) & bus::Mark::kLargestNumber;
  return {.hub = self_, .number = number_};
}

bool Origins::is_new(const bus::Mark& mark) noexcept {
  if (mark.hub == 0) return true;
  if (mark.hub == self_) return false;
  Origin& origin = origin_of(mark);
  origin.heard = ++clock_;
  const std::uint32_t ahead = (mark.number - origin.newest) & bus::Mark::kLargestNumber;
  const std::uint32_t behind = (origin.newest - mark.number) & bus::Mark::kLargestNumber;
  if (behind < kWindow) {
    if (origin.seen.test(mark.number % kWindow)) return false;
  } else {
    if (ahead >= kWindow) origin.seen.reset();
    for (std::uint32_t i = 1; i < std::min<std::uint32_t>(ahead, kWindow); ++i)
      origin.seen.reset((origin.newest + i) % kWindow);
    origin.newest = mark.number;
  }
  origin.seen.set(mark.number % kWindow);
  return true;
}

/// That of the mark's hub, new if it was not heard before.
Origins::Origin& Origins::origin_of(const bus::Mark& mark) noexcept {
  const auto known = std::ranges::find(origins_, mark.hub, &Origin::hub);
  if (known != origins_.end()) return *known;
  Origin& place = *std::ranges::min_element(origins_, {}, &Origin::heard);
  place = Origin{};
  place.hub = mark.hub;
  place.newest = mark.number;
  return place;
}

}  // namespace hub
