#pragma once

#include <cstddef>
#include <string>

#include <tl/expected.hpp>

namespace axisd {

/// Why a file could not be read.
struct UnreadableFile {
  bool is_missing = false;
  std::string reason;  ///< in a few words
};

/// Longest file that this program has a use for (bytes).
inline constexpr std::size_t kLongestFile = std::size_t{16} << 20;

/// The content of the file at @p path. What is no regular file (a folder, a FIFO, a device) is refused without
/// waiting for it, and so is one that is longer than kLongestFile.
[[nodiscard]] tl::expected<std::string, UnreadableFile> read_regular_file(const std::string& path);

}  // namespace axisd
