#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace record {

/// Memory in which bytes lie behind one another without end: what is at place n is at n modulo the size of it. It
/// is the system's until it is used for the first time.
class ByteRing {
 public:
  explicit ByteRing(std::size_t size) : bytes_{std::make_unique_for_overwrite<std::byte[]>(size)}, size_{size} {}
  std::size_t size() const noexcept { return size_; }

  /// Puts @p bytes to place @p at; returns the place behind them.
  std::uint64_t put(std::uint64_t at, std::span<const std::byte> bytes) noexcept {
    const std::size_t before_end = std::min(bytes.size(), room_at(at));
    std::ranges::copy(bytes.first(before_end), place(at));
    std::ranges::copy(bytes.subspan(before_end), bytes_.get());
    return at + bytes.size();
  }
  /// Fills @p bytes from place @p at on; returns the place behind them.
  std::uint64_t get(std::uint64_t at, std::span<std::byte> bytes) const noexcept {
    const std::size_t before_end = std::min(bytes.size(), room_at(at));
    std::copy_n(place(at), before_end, bytes.begin());
    std::ranges::copy_n(bytes_.get(), static_cast<std::ptrdiff_t>(bytes.size() - before_end),
                        bytes.subspan(before_end).begin());
    return at + bytes.size();
  }

 private:
  std::byte* place(std::uint64_t at) const noexcept { return bytes_.get() + at % size_; }
  std::size_t room_at(std::uint64_t at) const noexcept { return size_ - static_cast<std::size_t>(at % size_); }

  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_;
};

}  // namespace record
