#pragma once

#include <cerrno>

namespace preload {

/// What a call returns that has failed with @p error, which it leaves in errno.
inline int failed(int error) noexcept {
  errno = error;
  return -1;
}

}  // namespace preload
