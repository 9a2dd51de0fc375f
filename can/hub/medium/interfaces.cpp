#include "can/hub/medium/interfaces.hpp"

#include <algorithm>
#include <limits>

#include "can/userbus/interface_name.hpp"

namespace hub {

Interfaces::Interfaces() {
  entries_.reserve(kMost);
}

int Interfaces::index_of(std::string_view name) noexcept {
  const auto same = [name](const userbus::InterfaceEntry& entry) { return name == entry.name; };
  const auto known = std::ranges::find_if(entries_, same);
  std::size_t place = static_cast<std::size_t>(known - entries_.begin());
  if (known == entries_.end()) {
    if (!userbus::is_can_name(name.data(), name.size())) return 0;
    place = free_place();
    if (place == kMost) return 0;
    std::ranges::copy(name, entries_[place].name);
  }
  uses_[place].mentioned = ++mentions_;
  return entries_[place].index;
}

/// A place for a name, with its index and without the name; kMost if members are bound to all.
std::size_t Interfaces::free_place() noexcept {
  if (entries_.size() < kMost) {
    entries_.push_back({.index = kFirstIndex + static_cast<int>(entries_.size()), .name = {}});
    return entries_.size() - 1;
  }
  const Use* oldest = nullptr;
  for (const Use& use : uses_)
    if (use.members == 0 && (oldest == nullptr || use.mentioned < oldest->mentioned)) oldest = &use;
  if (oldest == nullptr) return kMost;
  const auto place = static_cast<std::size_t>(oldest - uses_.data());
  constexpr int kLast = std::numeric_limits<int>::max() - static_cast<int>(kMost);
  const int before = entries_[place].index;
  const int next = before < kLast ? before + static_cast<int>(kMost) : kFirstIndex + static_cast<int>(place);
  entries_[place] = {.index = next, .name = {}};
  return place;
}

/// kMost if @p index is none.
std::size_t Interfaces::place_of(int index) const noexcept {
  if (index < kFirstIndex) return kMost;
  const std::size_t place = static_cast<std::size_t>(index - kFirstIndex) % kMost;
  return place < entries_.size() && entries_[place].index == index ? place : kMost;
}

void Interfaces::hold(int index) noexcept {
  if (const std::size_t place = place_of(index); place != kMost) ++uses_[place].members;
}

void Interfaces::release(int index) noexcept {
  if (const std::size_t place = place_of(index); place != kMost) --uses_[place].members;
}

std::string_view Interfaces::name_of(int index) const noexcept {
  const std::size_t place = place_of(index);
  return place == kMost ? std::string_view{} : entries_[place].name;
}

int Interfaces::common_index() noexcept {
  return entries_.empty() ? index_of(kFallbackName) : entries_.front().index;
}

}  // namespace hub
