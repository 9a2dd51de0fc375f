#pragma once

#include <utility>

#include <unistd.h>

namespace os {

/// Owner of one file descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  /// Takes @p number over; a negative one stands for "none".
  explicit Descriptor(int number) noexcept : number_{number} {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  /// True if a descriptor is held.
  explicit operator bool() const noexcept { return number_ >= 0; }
  /// The descriptor's number, negative if none is held.
  [[nodiscard]] int get() const noexcept { return number_; }

 private:
  int number_ = -1;
};

}  // namespace os
