#include "can/hub/path/path_lock.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hub {

namespace {

constexpr mode_t kOwnerOnly = 0600;

/// The last owner removes the file: a lock on a file that is not at @p name any more is worth nothing.
bool is_still_at(int descriptor, const std::string& name) noexcept {
  struct stat held {};
  struct stat named {};
  return fstat(descriptor, &held) == 0 && lstat(name.c_str(), &named) == 0 && held.st_dev == named.st_dev &&
         held.st_ino == named.st_ino;
}

}  // namespace

std::string lock_path(const std::string& path) {
  return path + ".lock";
}

os::Descriptor try_lock(const std::string& path) noexcept {
  const std::string name = lock_path(path);
  for (;;) {
    os::Descriptor lock{
        open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY, kOwnerOnly)};
    if (!lock || flock(lock.get(), LOCK_EX | LOCK_NB) != 0) return os::Descriptor{};
    if (is_still_at(lock.get(), name)) return lock;
  }
}

void remove_lock(const std::string& path, const os::Descriptor& lock) noexcept {
  const std::string name = lock_path(path);
  if (is_still_at(lock.get(), name)) unlink(name.c_str());
}

}  // namespace hub
