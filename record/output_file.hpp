#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "os/descriptor.hpp"

namespace record {

/// A file that is written from front to back, in large pieces. Every function that writes gives 0 or an errno.
class OutputFile {
 public:
  OutputFile();

  /// Begins the file at @p path, which replaces what was there; its folder exists.
  [[nodiscard]] int open(const std::string& path) noexcept;
  bool is_open() const noexcept { return static_cast<bool>(file_); }
  [[nodiscard]] int write(std::span<const std::byte> bytes) noexcept;
  [[nodiscard]] int write(std::string_view text) noexcept {
    return write(std::as_bytes(std::span{text.data(), text.size()}));
  }
  /// Hands everything to the system.
  [[nodiscard]] int flush() noexcept;
  /// Closes the file; what is not flushed is lost.
  void close() noexcept;
  /// Bytes that were written.
  std::uint64_t size() const noexcept { return size_; }

 private:
  os::Descriptor file_;
  std::vector<std::byte> buffer_;
  std::uint64_t size_ = 0;
};

}  // namespace record
