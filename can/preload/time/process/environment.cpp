#include "can/preload/time/process/environment.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/mman.h>

#include "can/preload/time/base/clock.hpp"

namespace preload {

namespace {

constexpr const char* kNames[] = {"LD_PRELOAD", "CAN_BUS", "CAN_TIME", "CAN_BITRATE"};
constexpr std::size_t kNameCount = sizeof kNames / sizeof kNames[0];

/// NAME=VALUE of each, empty where the process had none.
char noted[kNameCount][4096];

bool has(char* const* entries, const char* name) noexcept {
  const std::size_t length = strlen(name);
  for (; *entries != nullptr; ++entries)
    if (strncmp(*entries, name, length) == 0 && (*entries)[length] == '=') return true;
  return false;
}

}  // namespace

void note_environment() noexcept {
  for (std::size_t i = 0; i < kNameCount; ++i) {
    const char* const value = getenv(kNames[i]);
    const int length = value == nullptr ? 0 : snprintf(noted[i], sizeof noted[i], "%s=%s", kNames[i], value);
    if (static_cast<std::size_t>(length) >= sizeof noted[i]) noted[i][0] = '\0';
  }
}

ProgramEnvironment::ProgramEnvironment(char* const* given) noexcept : given_{given} {
  static char* const kNone[] = {nullptr};
  if (!by_turns()) return;
  if (given_ == nullptr) given_ = kNone;
  std::size_t count = 0;
  while (given_[count] != nullptr) ++count;
  size_ = (count + kNameCount + 1) * sizeof *given_;
  void* const room = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return;
  added_ = static_cast<char**>(room);
  memcpy(added_, given_, count * sizeof *given_);
  for (std::size_t i = 0; i < kNameCount; ++i)
    if (noted[i][0] != '\0' && !has(given_, kNames[i])) added_[count++] = noted[i];
}

ProgramEnvironment::~ProgramEnvironment() {
  if (added_ == nullptr) return;
  const int error = errno;
  munmap(added_, size_);
  errno = error;
}

}  // namespace preload
