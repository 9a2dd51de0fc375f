#include "can/hub/member/filter_set.hpp"

#include <algorithm>
#include <array>

namespace hub {

FilterSet::FilterSet() {
  constexpr std::array kAll{can_filter{.can_id = 0, .can_mask = 0}};
  assign(kAll);
}

void FilterSet::assign(std::span<const can_filter> filters) {
  given_.assign(filters.begin(), filters.end());
  rules_.resize(filters.size());
  std::ranges::transform(filters, rules_.begin(), prepare);
}

FilterSet::Rule FilterSet::prepare(const can_filter& filter) noexcept {
  if ((filter.can_mask & CAN_ERR_FLAG) != 0)
    return {.id = 0, .mask = filter.can_mask & CAN_ERR_MASK, .inverted = false, .for_errors = true};
  canid_t mask = filter.can_mask;
  // one that asks for the standard format only has no more than 11 bits to compare
  if ((mask & CAN_EFF_FLAG) != 0 && (filter.can_id & CAN_EFF_FLAG) == 0)
    mask &= CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG;
  return {.id = filter.can_id & mask,
          .mask = mask,
          .inverted = (filter.can_id & CAN_INV_FILTER) != 0,
          .for_errors = false};
}

bool FilterSet::matches(const Rule& rule, canid_t id) noexcept {
  const bool error = (id & CAN_ERR_FLAG) != 0;
  if (error != rule.for_errors) return false;
  if (error) return (id & rule.mask) != 0;
  return ((id & rule.mask) == rule.id) != rule.inverted;
}

bool FilterSet::passes(canid_t id) const noexcept {
  const bool by_error_mask = (id & CAN_ERR_FLAG) != 0 && (id & error_mask_) != 0;
  const auto match = [id](const Rule& rule) { return matches(rule, id); };
  if (!joined_) return by_error_mask || std::ranges::any_of(rules_, match);
  // the kernel counts matches, and takes the error mask for a filter more
  const auto found = std::ranges::count_if(rules_, match) + (by_error_mask ? 1 : 0);
  return found >= std::max<std::ptrdiff_t>(1, std::ssize(rules_));
}

}  // namespace hub
