#pragma once

#include <cstddef>

#include <sys/uio.h>

namespace preload {

/// Memory of a program in several parts, as readv(2) and sendmsg(2) take it.
struct Parts {
  const iovec* first;
  size_t count;
};

/// Bytes of all parts together.
size_t size_of(const Parts& parts) noexcept;

/// Writes the first @p size bytes of @p data into @p parts, as far as they have room; returns how many that were.
size_t scatter(const void* data, size_t size, const Parts& parts) noexcept;

/// Copies what is in @p parts to @p room bytes at @p data, as far as they suffice; returns how many that were.
size_t gather(const Parts& parts, void* data, size_t room) noexcept;

}  // namespace preload
