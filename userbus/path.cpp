#include "userbus/path.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

namespace userbus {

namespace {

const char* set_variable(const char* name) noexcept {
  const char* const value = getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

bool fits(int length, const Path& path) noexcept {
  return length > 0 && static_cast<size_t>(length) < sizeof path.text;
}

}  // namespace

bool copy_path(const char* text, Path& path) noexcept {
  return fits(snprintf(path.text, sizeof path.text, "%s", text), path);
}

bool default_path(Path& path) noexcept {
  if (const char* const bus = set_variable("CAN_BUS")) return copy_path(bus, path);
  if (const char* const folder = set_variable("XDG_RUNTIME_DIR"))
    return fits(snprintf(path.text, sizeof path.text, "%s/can-bus", folder), path);
  return fits(snprintf(path.text, sizeof path.text, "/tmp/can-bus-%u", static_cast<unsigned>(getuid())), path);
}

}  // namespace userbus
