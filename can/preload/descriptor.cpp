#include "can/preload/descriptor.hpp"

#include <atomic>

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include "can/preload/next.hpp"

namespace preload {

namespace {

std::atomic<bool> expected;

/// The descriptor that an entry of /proc/self/fd names; -1 if it names none.
int number_of(const char* text) noexcept {
  int number = 0;
  for (; *text != '\0'; ++text) {
    if (*text < '0' || *text > '9') return -1;
    number = number * 10 + (*text - '0');
  }
  return number;
}

/// Reads the entries of @p folder, without the heap: other libraries may not have begun yet.
void look_at_entries(int folder) noexcept {
  alignas(dirent64) char entries[4096];
  ssize_t size = 0;
  while ((size = getdents64(folder, entries, sizeof entries)) > 0) {
    for (ssize_t at = 0; at < size;) {
      const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
      look_at(number_of(entry->d_name));
      at += entry->d_reclen;
    }
  }
}

}  // namespace

bool is_can(int descriptor, userbus::Name& name) noexcept {
  return expects_can_sockets() && userbus::name_of(descriptor, name) && name.kind != userbus::Kind::Port &&
         name.kind != userbus::Kind::Clock;
}

void expect_can_sockets() noexcept {
  expected.store(true, std::memory_order_relaxed);
}

bool expects_can_sockets() noexcept {
  return expected.load(std::memory_order_relaxed);
}

void look_at(int descriptor) noexcept {
  userbus::Name name{};
  if (userbus::name_of(descriptor, name)) expect_can_sockets();
}

void look_at_all() noexcept {
  const int folder = open("/proc/self/fd", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return expect_can_sockets();  // nobody tells: it may have some
  look_at_entries(folder);
  next().close(folder);
}

}  // namespace preload
