#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "libcanopen/od/abort_code.hpp"

namespace canopen {

/// What an SDO server has sent since it was made: frames, and among them aborts by their code. Nothing resets it.
class SdoAnswerCounters {
 public:
  /// Abort frames with one code.
  struct Aborts {
    AbortCode code{};
    std::uint64_t count = 0;
  };

  /// Frames under the response identifier.
  std::uint64_t frames() const noexcept { return frames_; }
  /// Codes that were sent, in the order of their first time.
  std::span<const Aborts> aborts() const noexcept {
    return {aborts_.data(),
            static_cast<std::size_t>(std::ranges::find(aborts_, 0U, &Aborts::count) - aborts_.begin())};
  }

  void count_frame() noexcept { ++frames_; }
  /// Beside count_frame().
  void count_abort(AbortCode code) noexcept {
    const auto row =
        std::ranges::find_if(aborts_, [&](const Aborts& known) { return known.count == 0 || known.code == code; });
    if (row == aborts_.end()) return;
    row->code = code;
    ++row->count;
  }

 private:
  static constexpr std::size_t kMostCodes = 32;  ///< more than AbortCode names

  std::uint64_t frames_ = 0;
  std::array<Aborts, kMostCodes> aborts_{};
};

}  // namespace canopen
