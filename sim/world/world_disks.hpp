#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "os/disk.hpp"
#include "sim/disk/simulated_disk.hpp"

namespace sim {

/// The disks of all units of a world, as the one that the process has: "/3/parameters.bin" is on that of unit 3.
class WorldDisks final : public os::Disk {
 public:
  /// The next unit keeps its state on @p disk, which outlives this.
  void add(SimulatedDisk& disk) { disks_.push_back(&disk); }

  // os::Disk
  int open(const char* path, int flags, mode_t mode) noexcept override;
  ssize_t write(int descriptor, std::span<const std::byte> content) noexcept override;
  int flush(int descriptor) noexcept override;
  int rename(const char* from, const char* to) noexcept override;
  int exchange(const char* one, const char* other) noexcept override;
  int unlink(const char* path) noexcept override;
  bool exists(const char* path) noexcept override;
  tl::expected<std::string, os::UnreadableFile> read(const std::string& path, std::size_t most) override;

 private:
  [[nodiscard]] SimulatedDisk& disk_of(std::string_view path) const noexcept;

  std::vector<SimulatedDisk*> disks_;
  std::map<int, SimulatedDisk*> opened_;  ///< by descriptor, the last that had it
};

}  // namespace sim
