#pragma once

#include <functional>

namespace fakes {

/// While it lives, fsync(2) of this program asks @p flush, with the descriptor, what comes of it: 0 or an error.
class FlushHook {
 public:
  explicit FlushHook(std::function<int(int descriptor)> flush);
  FlushHook(const FlushHook&) = delete;
  FlushHook& operator=(const FlushHook&) = delete;
  ~FlushHook();
};

}  // namespace fakes
