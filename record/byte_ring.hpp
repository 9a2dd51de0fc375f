#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace record {

/// Memory in which bytes lie behind one another without end: what is at place n is at n modulo the size of it.
class ByteRing {
 public:
  explicit ByteRing(std::size_t size) : bytes_(size) {}
  std::size_t size() const noexcept { return bytes_.size(); }

  /// Puts @p bytes to place @p at; returns the place behind them.
  std::uint64_t put(std::uint64_t at, std::span<const std::byte> bytes) noexcept {
    const auto first = static_cast<std::size_t>(at % bytes_.size());
    const std::size_t before_end = std::min(bytes.size(), bytes_.size() - first);
    std::copy_n(bytes.begin(), before_end, bytes_.begin() + static_cast<std::ptrdiff_t>(first));
    std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(before_end), bytes.end(), bytes_.begin());
    return at + bytes.size();
  }
  /// Fills @p bytes from place @p at on; returns the place behind them.
  std::uint64_t get(std::uint64_t at, std::span<std::byte> bytes) const noexcept {
    const auto first = static_cast<std::size_t>(at % bytes_.size());
    const std::size_t before_end = std::min(bytes.size(), bytes_.size() - first);
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(first), before_end, bytes.begin());
    std::copy_n(bytes_.begin(), bytes.size() - before_end,
                bytes.begin() + static_cast<std::ptrdiff_t>(before_end));
    return at + bytes.size();
  }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace record
