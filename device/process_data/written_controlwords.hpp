#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace device {

/// Controlwords written over SDO, one for each of the next cycles. SDO answers come faster than cycles here, and a
/// master that writes 6h, 7h and Fh one after the other means each of them. The real unit's SDO channel is slow
/// enough by itself; RPDOs have no such queue there either.
class WrittenControlwords {
 public:
  /// Appends @p word; with the queue full it takes the place of the newest.
  void put(std::uint16_t word) noexcept {
    if (count_ == words_.size()) --count_;
    words_[(first_ + count_++) % words_.size()] = word;
    newest_ = word;
  }
  /// Takes the oldest word out.
  std::optional<std::uint16_t> take() noexcept {
    if (count_ == 0) return std::nullopt;
    const std::uint16_t word = words_[first_];
    first_ = (first_ + 1) % words_.size();
    --count_;
    return word;
  }
  /// The word that was put last.
  std::uint16_t newest() const noexcept { return newest_; }
  /// Forgets every word.
  void clear() noexcept { count_ = 0; }
  bool is_empty() const noexcept { return count_ == 0; }

 private:
  std::array<std::uint16_t, 32> words_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::uint16_t newest_ = 0;
};

}  // namespace device
