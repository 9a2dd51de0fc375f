#include "sim/world/world_disks.hpp"

#include <cassert>
#include <charconv>

#include "sim/base/allocations.hpp"

namespace sim {

SimulatedDisk& WorldDisks::disk_of(std::string_view path) const noexcept {
  std::size_t number = 0;
  const auto read = std::from_chars(path.data() + 1, path.data() + path.size(), number);
  assert(path.starts_with('/') && read.ec == std::errc{} && number < disks_.size());
  static_cast<void>(read);
  return *disks_[number];
}

int WorldDisks::open(const char* path, int flags, mode_t mode) noexcept {
  const Uncounted uncounted;
  SimulatedDisk& disk = disk_of(path);
  const int descriptor = disk.open(path, flags, mode);
  if (descriptor >= 0) opened_[descriptor] = &disk;
  return descriptor;
}

ssize_t WorldDisks::write(int descriptor, std::span<const std::byte> content) noexcept {
  const Uncounted uncounted;
  return opened_.at(descriptor)->write(descriptor, content);
}

int WorldDisks::flush(int descriptor) noexcept {
  const Uncounted uncounted;
  return opened_.at(descriptor)->flush(descriptor);
}

int WorldDisks::rename(const char* from, const char* to) noexcept {
  const Uncounted uncounted;
  return disk_of(from).rename(from, to);
}

int WorldDisks::exchange(const char* one, const char* other) noexcept {
  const Uncounted uncounted;
  return disk_of(one).exchange(one, other);
}

int WorldDisks::unlink(const char* path) noexcept {
  const Uncounted uncounted;
  return disk_of(path).unlink(path);
}

bool WorldDisks::exists(const char* path) noexcept {
  return disk_of(path).exists(path);
}

tl::expected<std::string, os::UnreadableFile> WorldDisks::read(const std::string& path, std::size_t most) {
  const Uncounted uncounted;
  return disk_of(path).read(path, most);
}

}  // namespace sim
