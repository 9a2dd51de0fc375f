#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fuzz {

/// The input of one run, taken from its front; zeros after its end.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) noexcept : bytes_{bytes} {}
  bool is_empty() const noexcept { return bytes_.empty(); }
  std::uint8_t u8() noexcept {
    std::uint8_t byte = 0;
    fill({&byte, 1});
    return byte;
  }
  std::uint16_t u16() noexcept {
    const std::uint16_t low = u8();
    return static_cast<std::uint16_t>(low | u8() << 8);
  }
  std::uint32_t u32() noexcept {
    const std::uint32_t low = u16();
    return low | std::uint32_t{u16()} << 16;
  }
  /// Fills @p into, with zeros where the input has ended.
  void fill(std::span<std::uint8_t> into) noexcept {
    const std::size_t there = std::min(into.size(), bytes_.size());
    const auto rest = std::copy_n(bytes_.begin(), there, into.begin());
    std::fill(rest, into.end(), std::uint8_t{0});
    bytes_ = bytes_.subspan(there);
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace fuzz
