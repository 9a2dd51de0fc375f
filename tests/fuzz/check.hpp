#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/// Ends the program if @p holds is false, in every kind of build; @p rule says what should have been.
inline void require(bool holds, const char* rule) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", rule);
  std::abort();
}

}  // namespace fuzz
