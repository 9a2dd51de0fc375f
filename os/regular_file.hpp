#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace os {

/// Why a file could not be read.
struct UnreadableFile {
  enum class Why : std::uint8_t {
    System,      ///< `error` says it
    NotRegular,  ///< a FIFO, a socket, a device
    TooLong
  };
  Why why = Why::System;
  int error = 0;  ///< errno; EISDIR of a folder, EFBIG of what is too long

  [[nodiscard]] bool is_missing() const noexcept;
  /// In a few words, as the system says it.
  [[nodiscard]] std::string reason() const;
};

/// The content of the file at @p path. What is no regular file (a folder, a FIFO, a device) is refused without
/// waiting for it, and so is one of more than @p most bytes.
[[nodiscard]] tl::expected<std::string, UnreadableFile> read_regular_file(const std::string& path,
                                                                          std::size_t most);

}  // namespace os
