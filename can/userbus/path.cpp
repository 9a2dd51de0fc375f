#include "can/userbus/path.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/stat.h>
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

bool folder_in_tmp(Path& path) noexcept {
  return fits(snprintf(path.text, sizeof path.text, "/tmp/can-bus-%u", static_cast<unsigned>(geteuid())), path);
}

}  // namespace

bool copy_path(const char* text, Path& path) noexcept {
  return fits(snprintf(path.text, sizeof path.text, "%s", text), path);
}

bool default_folder(Path& path) noexcept {
  if (const char* const folder = set_variable("XDG_RUNTIME_DIR")) return copy_path(folder, path);
  return geteuid() == 0 ? copy_path("/run", path) : folder_in_tmp(path);
}

bool default_path(Path& path) noexcept {
  if (const char* const bus = set_variable("CAN_BUS")) return copy_path(bus, path);
  Path folder{};
  return default_folder(folder) && fits(snprintf(path.text, sizeof path.text, "%s/can-bus", folder.text), path);
}

bool own_folder(const Path& path) noexcept {
  Path folder{};
  if (!folder_in_tmp(folder)) return true;
  const size_t length = strlen(folder.text);
  if (strncmp(path.text, folder.text, length) != 0 || path.text[length] != '/') return true;
  if (mkdir(folder.text, S_IRWXU) != 0 && errno != EEXIST) return false;
  struct stat status {};
  if (lstat(folder.text, &status) != 0) return false;
  errno = EACCES;
  return S_ISDIR(status.st_mode) && status.st_uid == geteuid() && (status.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

}  // namespace userbus
