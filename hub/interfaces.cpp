#include "hub/interfaces.hpp"

#include <algorithm>

#include "userbus/interface_name.hpp"

namespace hub {

Interfaces::Interfaces() {
  entries_.reserve(kMost);
}

int Interfaces::index_of(std::string_view name) noexcept {
  const auto same = [name](const userbus::InterfaceEntry& entry) { return name == entry.name; };
  const auto known = std::ranges::find_if(entries_, same);
  if (known != entries_.end()) return known->index;
  if (!userbus::is_can_name(name.data(), name.size()) || entries_.size() == kMost) return 0;
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
