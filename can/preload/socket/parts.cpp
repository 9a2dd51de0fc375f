#include "can/preload/socket/parts.hpp"

#include <cstring>

namespace preload {

namespace {

size_t smaller(size_t a, size_t b) noexcept {
  return a < b ? a : b;
}

}  // namespace

size_t size_of(const Parts& parts) noexcept {
  size_t size = 0;
  for (size_t i = 0; i < parts.count; ++i) size += parts.first[i].iov_len;
  return size;
}

size_t scatter(const void* data, size_t size, const Parts& parts) noexcept {
  size_t done = 0;
  for (size_t i = 0; i < parts.count && done < size; ++i) {
    const size_t share = smaller(parts.first[i].iov_len, size - done);
    if (share == 0) continue;
    memcpy(parts.first[i].iov_base, static_cast<const char*>(data) + done, share);
    done += share;
  }
  return done;
}

size_t gather(const Parts& parts, void* data, size_t room) noexcept {
  size_t done = 0;
  for (size_t i = 0; i < parts.count && done < room; ++i) {
    const size_t share = smaller(parts.first[i].iov_len, room - done);
    if (share == 0) continue;
    memcpy(static_cast<char*>(data) + done, parts.first[i].iov_base, share);
    done += share;
  }
  return done;
}

}  // namespace preload
