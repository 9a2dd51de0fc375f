#pragma once

namespace os {

/// From now on @p program, a name that outlives this, ends with one line on the standard error and exit status @p
/// status where it gets no memory, or nothing else that it needs of the kernel (std::system_error), and cannot go
/// on without, as it does after other failures; it would be aborted. Other exceptions that nobody takes abort it
/// as before.
void end_if_memory_is_missing(const char* program, int status) noexcept;

}  // namespace os
