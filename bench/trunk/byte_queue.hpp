#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace bench {

/// Bytes on their way to a socket, or from one.
class ByteQueue {
 public:
  /// Those that wait, the oldest first; until something is put or taken.
  [[nodiscard]] std::span<const std::byte> waiting() const noexcept {
    return std::span{bytes_}.subspan(first_, end_ - first_);
  }
  /// The oldest @p count have done their part.
  void take(std::size_t count) noexcept {
    first_ += count;
    if (first_ == end_) first_ = end_ = 0;
  }
  /// Room for at least @p count behind the others, to be filled and then told by fill().
  [[nodiscard]] std::span<std::byte> room(std::size_t count) {
    if (first_ > 0 && bytes_.size() - end_ < count) {
      std::memmove(bytes_.data(), bytes_.data() + first_, end_ - first_);
      end_ -= first_;
      first_ = 0;
    }
    if (bytes_.size() - end_ < count) bytes_.resize(end_ + count);
    return std::span{bytes_}.subspan(end_);
  }
  void fill(std::size_t count) noexcept { end_ += count; }
  void put(std::span<const std::byte> bytes) {
    std::memcpy(room(bytes.size()).data(), bytes.data(), bytes.size());
    fill(bytes.size());
  }

 private:
  std::vector<std::byte> bytes_;
  std::size_t first_ = 0;
  std::size_t end_ = 0;
};

}  // namespace bench
