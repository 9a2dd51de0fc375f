#include "can/preload/time/turn/touch.hpp"

#include <atomic>
#include <cstdint>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "can/preload/next.hpp"
#include "can/preload/time/turn/turn.hpp"

namespace preload {

namespace {

/// Writing calls of the process that went through write(2) and writev(2) of this library.
std::atomic<uint64_t> seen_writes;
/// What there is more than these by the kernel's count, when it was last looked at.
uint64_t unseen_writes;
std::atomic<bool> stdio_may_touch;

bool is_null_device(dev_t device) noexcept {
  constexpr unsigned kMemory = 1;
  constexpr unsigned kNull = 3;
  return major(device) == kMemory && minor(device) == kNull;
}

/// A pipe, a socket, a terminal. What has no name and no type (an eventfd) is taken for the process's own.
bool is_seen_by_others(int descriptor) noexcept {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return false;
  if (S_ISCHR(status.st_mode)) return !is_null_device(status.st_rdev);
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
}

/// How often the process has called the kernel to write; 0 if the kernel does not count.
uint64_t count_writes() noexcept {
  const int file = open("/proc/self/io", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  char text[256];
  const ssize_t size = next().read(file, text, sizeof text - 1);
  next().close(file);
  if (size <= 0) return 0;
  text[size] = '\0';
  const char* at = strstr(text, "syscw: ");
  if (at == nullptr) return 0;
  uint64_t count = 0;
  constexpr uint64_t kTen = 10;
  for (at += strlen("syscw: "); *at >= '0' && *at <= '9'; ++at)
    count = count * kTen + static_cast<uint64_t>(*at - '0');
  return count;
}

}  // namespace

void note_writing(int descriptor) noexcept {
  seen_writes.fetch_add(1, std::memory_order_relaxed);
  if (is_seen_by_others(descriptor)) note_touched();
}

void note_closing(int descriptor) noexcept {
  if (is_seen_by_others(descriptor)) note_touched();
}

bool has_unseen_writes() noexcept {
  if (!stdio_may_touch.load(std::memory_order_relaxed)) return false;
  const uint64_t unseen = count_writes() - seen_writes.load(std::memory_order_relaxed);
  const bool more = unseen != unseen_writes;
  unseen_writes = unseen;
  return more;
}

void expect_unseen_writes() noexcept {
  stdio_may_touch.store(true, std::memory_order_relaxed);
}

void begin_to_see_writes() noexcept {
  seen_writes = 0;
  unseen_writes = count_writes();
  if (is_seen_by_others(STDOUT_FILENO) || is_seen_by_others(STDERR_FILENO)) expect_unseen_writes();
}

}  // namespace preload
