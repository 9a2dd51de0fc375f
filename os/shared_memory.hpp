#pragma once

#include <cstddef>

#include "os/descriptor.hpp"

namespace os {

/// Memory that this process writes, and that others who get its descriptor can only read.
class SharedMemory {
 public:
  SharedMemory() = default;
  /// @p size bytes of zero, called @p name for people (proc(5)); std::system_error.
  SharedMemory(const char* name, std::size_t size);
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  ~SharedMemory();

  /// Where it begins; nullptr if there is none.
  [[nodiscard]] void* begin() const noexcept { return begin_; }
  /// To be passed on; negative if there is none.
  [[nodiscard]] int descriptor() const noexcept { return file_.get(); }

 private:
  Descriptor file_;
  void* begin_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace os
