#pragma once

#include <cstddef>
#include <span>

namespace os {

/// Memory of whole pages that takes room only where it has been written to. Reads as zeros at first.
class FreshPages {
 public:
  /// Throws std::system_error if there is no room for @p size bytes (positive) among the addresses.
  explicit FreshPages(std::size_t size);
  ~FreshPages();
  FreshPages(const FreshPages&) = delete;
  FreshPages& operator=(const FreshPages&) = delete;

  /// All of it, aligned to a page.
  [[nodiscard]] std::span<std::byte> bytes() const noexcept { return bytes_; }
  /// As at first: takes no room any more. A system call.
  void give_back() noexcept;

 private:
  std::span<std::byte> bytes_;
};

}  // namespace os
