#pragma once

namespace drive {

/// A time told in cycles: cycle times are sums of rounded fractions, so a limit is met within a nanosecond.
constexpr bool elapsed(double time, double limit) noexcept {
  return time >= limit - 1e-9;
}

}  // namespace drive
