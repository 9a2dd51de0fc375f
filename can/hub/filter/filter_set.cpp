#include "can/hub/filter/filter_set.hpp"

#include <algorithm>
#include <utility>

namespace hub {

namespace {

/// Numbers of standard frames in a word of StandardFrames, and the bits of a number that tell them apart.
constexpr unsigned kBitsOfWord = 6;
constexpr std::size_t kInWord = (std::size_t{1} << kBitsOfWord) - 1;

/// The numbers in any word whose bits under @p mask are @p wanted, both of kBitsOfWord bits.
std::uint64_t pattern_of(std::size_t mask, std::size_t wanted) noexcept {
  std::uint64_t pattern = std::uint64_t{1} << wanted;
  for (unsigned bit = 0; bit < kBitsOfWord; ++bit)
    if ((mask >> bit & 1) == 0) pattern |= pattern << (1U << bit);
  return pattern;
}

}  // namespace

FilterSet::FilterSet() {
  constexpr std::array kAll{can_filter{.can_id = 0, .can_mask = 0}};
  assign(kAll);
}

void FilterSet::assign(std::span<const can_filter> filters) {
  std::vector<can_filter> given(filters.begin(), filters.end());
  std::vector<Rule> rules(filters.size());
  std::ranges::transform(filters, rules.begin(), prepare);
  given_ = std::move(given);
  rules_ = std::move(rules);
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

StandardFrames FilterSet::standard() const noexcept {
  StandardFrames all{};
  if (joined_ && !rules_.empty()) all.fill(~std::uint64_t{0});
  for (const Rule& rule : rules_) {
    const StandardFrames some = standard(rule);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = joined_ ? all[i] & some[i] : all[i] | some[i];
  }
  return all;
}

/// A word at a time: its place decides on the upper bits of the numbers in it, and the lower ones make the same
/// pattern in all words.
StandardFrames FilterSet::standard(const Rule& rule) noexcept {
  StandardFrames frames{};
  if (rule.for_errors) return frames;
  constexpr canid_t kBits = CAN_SFF_MASK | CAN_RTR_FLAG;
  const bool can_match = (rule.id & ~kBits) == 0;  // all other bits of a standard frame are 0
  const std::size_t mask = standard_number(rule.mask);
  const std::size_t wanted = standard_number(rule.id);
  const std::uint64_t pattern = can_match ? pattern_of(mask & kInWord, wanted & kInWord) : 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::uint64_t matching = (i & mask >> kBitsOfWord) == wanted >> kBitsOfWord ? pattern : 0;
    frames[i] = rule.inverted ? ~matching : matching;
  }
  return frames;
}

FilterSet::Extended FilterSet::extended() const noexcept {
  if (joined_ && rules_.size() > 1) return Extended::Judged;
  Extended most = Extended::None;
  for (const Rule& rule : rules_) most = std::max(most, extended(rule));
  return most;
}

FilterSet::Extended FilterSet::extended(const Rule& rule) noexcept {
  if (rule.for_errors) return Extended::None;
  if (rule.inverted) return rule.mask == 0 ? Extended::None : Extended::Judged;
  if ((rule.mask & CAN_EFF_FLAG) != 0 && (rule.id & CAN_EFF_FLAG) == 0) return Extended::None;
  if ((rule.mask & ~CAN_EFF_FLAG) == 0) return Extended::All;
  return (rule.mask & CAN_EFF_MASK) == CAN_EFF_MASK ? Extended::Listed : Extended::Judged;
}

std::vector<canid_t> FilterSet::exact_extended() const {
  std::vector<canid_t> ids;
  ids.reserve(2 * rules_.size());
  for (const Rule& rule : rules_) {
    if (extended(rule) != Extended::Listed) continue;
    ids.push_back(rule.id | CAN_EFF_FLAG);
    if ((rule.mask & CAN_RTR_FLAG) == 0) ids.push_back(rule.id | CAN_EFF_FLAG | CAN_RTR_FLAG);
  }
  return ids;
}

bool FilterSet::takes_errors() const noexcept {
  return error_mask_ != 0 || std::ranges::any_of(rules_, &Rule::for_errors);
}

}  // namespace hub
