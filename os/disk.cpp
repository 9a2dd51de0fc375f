#include "os/disk.hpp"

#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace os {
namespace {

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): a process has one disk, and says once which one
Disk machine_disk;
Disk* disk_in_use = &machine_disk;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

int Disk::open(const char* path, int flags, mode_t mode) noexcept {
  return ::open(path, flags, mode);
}

ssize_t Disk::write(int descriptor, std::span<const std::byte> content) noexcept {
  return ::write(descriptor, content.data(), content.size());
}

int Disk::flush(int descriptor) noexcept {
  return ::fsync(descriptor);
}

int Disk::rename(const char* from, const char* to) noexcept {
  return ::rename(from, to);
}

int Disk::exchange(const char* one, const char* other) noexcept {
  return ::renameat2(AT_FDCWD, one, AT_FDCWD, other, RENAME_EXCHANGE);
}

int Disk::unlink(const char* path) noexcept {
  return ::unlink(path);
}

bool Disk::exists(const char* path) noexcept {
  return ::access(path, F_OK) == 0;
}

tl::expected<std::string, UnreadableFile> Disk::read(const std::string& path, std::size_t most) {
  return read_regular_file(path, most);
}

Disk& disk() noexcept {
  return *disk_in_use;
}

void use_disk(Disk& other) noexcept {
  disk_in_use = &other;
}

}  // namespace os
