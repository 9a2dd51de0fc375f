#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace axisd {

/// A few listeners, in the order in which they came; nothing is allocated.
template <class Listener>
class Listeners {
 public:
  static constexpr std::ptrdiff_t kMost = 8;

  /// False if there is no place left; one that listens already counts once.
  [[nodiscard]] bool add(Listener& listener) noexcept {
    if (has(listener)) return true;
    if (count_ == kMost) return false;
    items_[static_cast<std::size_t>(count_++)] = &listener;
    return true;
  }
  void remove(const Listener& listener) noexcept {
    const auto end = std::remove(items_.begin(), items_.begin() + count_, &listener);
    count_ = end - items_.begin();
  }
  bool is_empty() const noexcept { return count_ == 0; }
  std::span<Listener* const> all() const noexcept { return {items_.data(), static_cast<std::size_t>(count_)}; }

 private:
  bool has(const Listener& listener) const noexcept { return std::ranges::find(all(), &listener) != all().end(); }

  std::array<Listener*, static_cast<std::size_t>(kMost)> items_{};
  std::ptrdiff_t count_ = 0;
};

}  // namespace axisd
