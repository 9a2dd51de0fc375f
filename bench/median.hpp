#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bench {

/// The middle one of @p values, of which there is one at least; of an even number the upper one.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace bench
