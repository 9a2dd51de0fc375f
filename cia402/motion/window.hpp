#pragma once

#include <cstdint>
#include <limits>

namespace cia402 {

/// The value of a window that is not watched (6065h, 6067h; CiA 402-2).
inline constexpr std::uint32_t kNoWindow = 0xFFFFFFFF;

/// Whether something has been so for a time, in cycles of 1 ms.
class Window {
 public:
  /// It is, or is not, @p inside in this cycle; true when it has been since a cycle @p milliseconds ago.
  bool update(bool inside, std::uint32_t milliseconds) noexcept {
    if (!inside) {
      since_ = 0;
      return false;
    }
    const bool is_long = since_ >= milliseconds;
    if (!is_long) ++since_;
    return is_long;
  }
  /// Counts anew.
  void restart() noexcept { since_ = 0; }
  /// As if it had been so for ever.
  void satisfy() noexcept { since_ = std::numeric_limits<std::uint32_t>::max(); }

 private:
  std::uint32_t since_ = 0;  // cycles
};

}  // namespace cia402
