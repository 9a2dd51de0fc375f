#include "hub/interfaces.hpp"

#include <algorithm>

namespace hub {

namespace {

constexpr std::size_t kLongestName = sizeof(userbus::InterfaceEntry::name) - 1;

constexpr bool is_lower(char c) noexcept {
  return c >= 'a' && c <= 'z';
}

constexpr bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

}  // namespace

Interfaces::Interfaces() {
  entries_.reserve(kMost);
}

bool Interfaces::is_can_name(std::string_view name) noexcept {
  if (name.size() > kLongestName) return false;
  const auto digits = std::ranges::find_if_not(name, is_lower);
  const std::string_view letters{name.begin(), digits};
  return digits != name.end() && std::all_of(digits, name.end(), is_digit) &&
         letters.find("can") != std::string_view::npos;
}

int Interfaces::index_of(std::string_view name) noexcept {
  const auto same = [name](const userbus::InterfaceEntry& entry) { return name == entry.name; };
  const auto known = std::ranges::find_if(entries_, same);
  if (known != entries_.end()) return known->index;
  if (!is_can_name(name) || entries_.size() == kMost) return 0;
  userbus::InterfaceEntry entry{.index = kFirstIndex + static_cast<int>(entries_.size()), .name = {}};
  std::ranges::copy(name, entry.name);
  entries_.push_back(entry);
  return entry.index;
}

std::string_view Interfaces::name_of(int index) const noexcept {
  if (index < kFirstIndex || index >= kFirstIndex + static_cast<int>(entries_.size())) return {};
  return entries_[static_cast<std::size_t>(index - kFirstIndex)].name;
}

int Interfaces::common_index() noexcept {
  return entries_.empty() ? index_of(kFallbackName) : entries_.front().index;
}

}  // namespace hub
