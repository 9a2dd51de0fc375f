#include "tools/sheet_file.hpp"

#include <cerrno>
#include <string_view>

#include <fmt/format.h>

#include "os/regular_file.hpp"

namespace tools {
namespace {

std::string reason_of(const os::UnreadableFile& file) {
  using Why = os::UnreadableFile::Why;
  if (file.why == Why::TooLong) return fmt::format("expected at most {} MiB", kLargestSheet >> 20U);
  const bool is_folder = file.why == Why::System && file.error == EISDIR;
  return is_folder || file.why == Why::NotRegular ? "expected a regular file" : file.reason();
}

}  // namespace

tl::expected<std::string, std::string> read_sheet_file(const std::string& path) {
  auto content = os::read_regular_file(path, kLargestSheet);
  if (content) return *std::move(content);
  return tl::unexpected{fmt::format("{}: cannot be read: {}", path, reason_of(content.error()))};
}

}  // namespace tools
