#include "can/preload/time/process/environment.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "can/preload/time/base/clock.hpp"

namespace preload {

namespace {

constexpr const char* kNames[] = {"LD_PRELOAD", "CAN_BUS", "CAN_TIME"};
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

ProgramEnvironment::ProgramEnvironment(char* const* given) noexcept : entries_{given} {
  std::size_t count = 0;
  if (!by_turns() || given == nullptr) return;
  while (given[count] != nullptr) ++count;
  if (count + kNameCount >= kMost) return;
  memcpy(added_, given, count * sizeof *given);
  for (std::size_t i = 0; i < kNameCount; ++i)
    if (noted[i][0] != '\0' && !has(given, kNames[i])) added_[count++] = noted[i];
  added_[count] = nullptr;
  entries_ = added_;
}

}  // namespace preload
