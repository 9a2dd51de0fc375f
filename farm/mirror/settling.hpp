#pragma once

#include <algorithm>
#include <optional>

#include "farm/mirror/directory.hpp"

namespace farm {

/// When those who were asked who is there count as all: when nobody new has told it for some time, and at last
/// when it has taken too long.
class Settling {
 public:
  /// Settled when nobody new has come for @p quiet, or after @p longest.
  Settling(Instant quiet, Instant longest) noexcept : quiet_{quiet}, longest_{longest} {}

  /// They are asked at @p now.
  void begin(Instant now) noexcept { asked_ = newest_ = now; }
  /// Somebody new has told at @p now.
  void take_new(Instant now) noexcept { newest_ = now; }
  /// When it is settled, as far as can be said now; nothing before begin().
  [[nodiscard]] std::optional<Instant> due() const noexcept {
    if (!asked_) return std::nullopt;
    return std::min(newest_ + quiet_, *asked_ + longest_);
  }

 private:
  Instant quiet_;
  Instant longest_;
  std::optional<Instant> asked_;
  Instant newest_{};
};

}  // namespace farm
