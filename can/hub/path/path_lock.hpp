#pragma once

#include <string>

#include "os/descriptor.hpp"

namespace hub {

/// Tries once to get the lock file of the bus at @p path; nothing with errno EWOULDBLOCK if somebody else has it,
/// with another errno if there can be none.
os::Descriptor try_lock(const std::string& path) noexcept;

/// Removes the lock file of the bus at @p path if it is still the one that @p lock is.
void remove_lock(const std::string& path, const os::Descriptor& lock) noexcept;

/// Name of the lock file of the bus at @p path.
std::string lock_path(const std::string& path);

}  // namespace hub
