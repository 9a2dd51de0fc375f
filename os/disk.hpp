#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "os/regular_file.hpp"

namespace os {

/// Where a program keeps what outlives it: the system calls of the machine. What a disk can do to it is tried with
/// another one in its place (use_disk()). All functions are those of the system, with its errors in errno.
class Disk {
 public:
  Disk() = default;
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  virtual ~Disk() = default;

  /// open(2). What it gives is closed by close(2), whatever disk it is of.
  [[nodiscard]] virtual int open(const char* path, int flags, mode_t mode) noexcept;
  /// write(2).
  [[nodiscard]] virtual ssize_t write(int descriptor, std::span<const std::byte> content) noexcept;
  /// fsync(2), of a file or a folder.
  [[nodiscard]] virtual int flush(int descriptor) noexcept;
  /// rename(2).
  [[nodiscard]] virtual int rename(const char* from, const char* to) noexcept;
  /// renameat2(2) with RENAME_EXCHANGE.
  [[nodiscard]] virtual int exchange(const char* one, const char* other) noexcept;
  /// unlink(2).
  virtual int unlink(const char* path) noexcept;
  /// access(2) with F_OK.
  [[nodiscard]] virtual bool exists(const char* path) noexcept;
  /// read_regular_file().
  [[nodiscard]] virtual tl::expected<std::string, UnreadableFile> read(const std::string& path, std::size_t most);
};

/// That of the process.
[[nodiscard]] Disk& disk() noexcept;
/// The process keeps what it has on @p other from now on, which outlives it; before it has threads.
void use_disk(Disk& other) noexcept;

}  // namespace os
