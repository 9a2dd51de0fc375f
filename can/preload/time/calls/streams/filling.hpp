#pragma once

#include <cstdio>

namespace preload {

/// Whether the C library's own reading of @p stream may wait in the kernel, where this library does not see it.
bool may_wait_within(std::FILE* stream) noexcept;

/// Before the C library reads from @p stream: waits by turns if its buffer is empty. False with errno, and the
/// stream says that there was an error, after a signal.
bool may_fill(std::FILE* stream) noexcept;

/// The next character, EOF at the end or after an error; the caller has the stream's lock.
int next_character(std::FILE* stream) noexcept;

}  // namespace preload
