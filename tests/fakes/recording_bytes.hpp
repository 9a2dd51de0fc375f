#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "checksum/crc32.hpp"
#include "record/format.hpp"

namespace fakes {

/// The bytes of a recording, record by record.
class RecordingBytes {
 public:
  /// Begins with the head @p head, a JSON object.
  explicit RecordingBytes(std::string_view head) {
    bytes_ = std::string{record::kMagic} + number(record::kVersion, 2) + number(0, 2) + number(head.size(), 4);
    add(std::as_bytes(std::span{head}));
  }
  /// A record behind the others, with its checksum.
  void add(std::span<const std::byte> record) {
    for (const std::byte byte : record) bytes_ += static_cast<char>(byte);
    bytes_ += number(checksum::crc32(record), record::kChecksumBytes);
  }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  /// @p value as @p size bytes, the least significant first.
  static std::string number(std::uint64_t value, unsigned size) {
    std::string bytes;
    for (unsigned i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
    return bytes;
  }

  std::string bytes_;
};

}  // namespace fakes
