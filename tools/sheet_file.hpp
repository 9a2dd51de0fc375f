#pragma once

#include <cstddef>
#include <string>

#include <tl/expected.hpp>

namespace tools {

/// Bytes of the largest EDS or DCF that is read, far above those there are.
inline constexpr std::size_t kLargestSheet = std::size_t{32} << 20U;

/// The whole file at @p path, or why it cannot be read: "PATH: cannot be read: WHY". Whatever the path leads to,
/// it comes back at once: only a regular file of at most kLargestSheet bytes is read, no pipe, device or folder.
[[nodiscard]] tl::expected<std::string, std::string> read_sheet_file(const std::string& path);

}  // namespace tools
