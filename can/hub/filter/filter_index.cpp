#include "can/hub/filter/filter_index.hpp"

#include <algorithm>
#include <new>

namespace hub {

namespace {

constexpr std::uint64_t bit_of(FilterIndex::Place place) noexcept {
  return std::uint64_t{1} << (place % FilterIndex::kPlacesOfWord);
}

void set(std::uint64_t& word, std::uint64_t bit, bool is_on) noexcept {
  word = is_on ? word | bit : word & ~bit;
}

constexpr StandardFrames every_frame() noexcept {
  StandardFrames frames{};
  frames.fill(~std::uint64_t{0});
  return frames;
}

}  // namespace

FilterIndex::Place FilterIndex::add() {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const auto first_free = static_cast<std::size_t>(std::countr_one(blocks_[i]->used));
    if (first_free == kPlacesOfWord) continue;
    blocks_[i]->used |= bit_of(first_free);
    return i * kPlacesOfWord + first_free;
  }
  blocks_.push_back(std::make_unique<Block>());
  blocks_.back()->used = bit_of(0);
  return (blocks_.size() - 1) * kPlacesOfWord;
}

void FilterIndex::remove(Place place) noexcept {
  take_nothing(place);
  block_of(place).used &= ~bit_of(place);
}

void FilterIndex::take_all(Place place) noexcept {
  forget(place);
  set_standard(place, every_frame());
  for (Takers& each : block_of(place).takers) each.all |= bit_of(place);
}

void FilterIndex::take(Place place, const FilterSet& filters) noexcept {
  using Extended = FilterSet::Extended;
  forget(place);
  set_standard(place, filters.standard());
  const Extended extended = filters.extended();
  const bool is_listed = extended == Extended::Listed && list(place, filters);
  set(takers(place, Form::Extended).all, bit_of(place), extended == Extended::All);
  set(takers(place, Form::Extended).asked, bit_of(place),
      extended == Extended::Judged || (extended == Extended::Listed && !is_listed));
  set(takers(place, Form::Error).asked, bit_of(place), filters.takes_errors());
  takers(place, Form::Other).asked |= bit_of(place);
  block_of(place).filters[place % kPlacesOfWord] = &filters;
}

void FilterIndex::take_nothing(Place place) noexcept {
  forget(place);
  set_standard(place, {});
}

void FilterIndex::find(canid_t id) noexcept {
  if ((id & CAN_ERR_FLAG) != 0) return find_among(Form::Error, id);
  if ((id & CAN_EFF_FLAG) != 0) {
    find_among(Form::Extended, id);
    return find_exact(id);
  }
  if ((id & ~(CAN_SFF_MASK | CAN_RTR_FLAG)) != 0) return find_among(Form::Other, id);
  for (const auto& block : blocks_) block->found = block->standard[standard_number(id)];
}

void FilterIndex::find_among(Form form, canid_t id) noexcept {
  for (const auto& block : blocks_) {
    const Takers& takers = block->takers[static_cast<std::size_t>(form)];
    block->found = takers.all;
    for (std::uint64_t left = takers.asked; left != 0; left &= left - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(left));
      if (block->filters[place]->passes(id)) block->found |= bit_of(place);
    }
  }
}

void FilterIndex::find_exact(canid_t id) noexcept {
  auto next = std::lower_bound(exact_.begin(), exact_.end(), Exact{id, 0});
  for (; next != exact_.end() && next->id == id; ++next) block_of(next->place).found |= bit_of(next->place);
}

void FilterIndex::set_standard(Place place, const StandardFrames& frames) noexcept {
  Block& block = block_of(place);
  for (std::size_t i = 0; i < kStandardFrames; ++i)
    set(block.standard[i], bit_of(place), (frames[i / kPlacesOfWord] >> i % kPlacesOfWord & 1) != 0);
}

/// False if there is no memory for that.
bool FilterIndex::list(Place place, const FilterSet& filters) noexcept {
  const auto before = static_cast<std::ptrdiff_t>(exact_.size());
  try {
    const std::vector<canid_t> ids = filters.exact_extended();
    exact_.reserve(exact_.size() + ids.size());
    for (const canid_t id : ids) exact_.push_back({id, static_cast<std::uint32_t>(place)});
  } catch (const std::bad_alloc&) {
    return false;
  }
  std::sort(exact_.begin() + before, exact_.end());
  std::inplace_merge(exact_.begin(), exact_.begin() + before, exact_.end());
  return true;
}

/// But for the standard frames.
void FilterIndex::forget(Place place) noexcept {
  for (Takers& each : block_of(place).takers) {
    each.all &= ~bit_of(place);
    each.asked &= ~bit_of(place);
  }
  std::erase_if(exact_, [place](const Exact& exact) { return exact.place == place; });
}

}  // namespace hub
