#include "can/port/filter_list.hpp"

#include <algorithm>

#include "can/port/wire.hpp"

namespace bus {

void FilterList::assign(std::span<const Filter> filters) noexcept {
  if (filters.size() > filters_.size()) {
    filters_[0] = can_filter{0, 0};
    count_ = 1;
    return;
  }
  std::transform(filters.begin(), filters.end(), filters_.begin(), [](const Filter& f) { return to_wire(f); });
  count_ = filters.size();
}

bool FilterList::pass(const canopen::Frame& frame) const noexcept {
  const canid_t identifier = to_wire(frame).can_id;
  const auto filters = get();
  return std::any_of(filters.begin(), filters.end(), [identifier](const can_filter& filter) {
    return (identifier & filter.can_mask) == (filter.can_id & filter.can_mask);
  });
}

}  // namespace bus
