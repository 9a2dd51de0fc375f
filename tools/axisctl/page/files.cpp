#include "tools/axisctl/page/files.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "control/eds_file.hpp"
#include "os/descriptor.hpp"
#include "os/regular_file.hpp"

namespace axisctl {
namespace {

constexpr std::size_t kLargestInput = std::size_t{64} << 20U;
constexpr double kMegabyte = 1e6;
constexpr mode_t kReadable = 0666;  // but for what umask takes away

tl::unexpected<Failure> not_written(const std::string& path, int error) {
  return fail(ExitStatus::Failed,
              fmt::format("{}: cannot be written: {}", path, std::generic_category().message(error)));
}

Expected<std::string> read_input(const std::string& path) {
  auto content = os::read_regular_file(path, kLargestInput);
  if (content) return *std::move(content);
  const ExitStatus status = content.error().is_missing() ? ExitStatus::NotThere : ExitStatus::Failed;
  return fail(status, fmt::format("{}: cannot be read: {}", path, content.error().reason()));
}

/// Writes @p content to @p file; 0 or an errno.
int write_all(const os::Descriptor& file, std::string_view content) noexcept {
  while (!content.empty()) {
    const ssize_t written = ::write(file.get(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file.get()) == 0 ? 0 : errno;
}

}  // namespace

std::string program_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

std::filesystem::path installed(std::string_view name) {
  return (std::filesystem::path{program_folder()} / "../share/axisd" / name).lexically_normal();
}

Expected<std::string> read_template(const std::string& path) {
  const std::string chosen = path.empty() ? installed("web/session.html").string() : path;
  auto page = read_input(chosen);
  if (!page && path.empty()) page.error().message += "; it comes with axisd-http, --template names another one";
  return page;
}

Expected<std::string> read_eds(const std::string& path, std::string_view profile, std::size_t axes) {
  if (!path.empty()) return read_input(path);
  const std::filesystem::path file = installed("eds/" + control::eds_file_name(profile, axes));
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::string{};
  return read_input(file.string());
}

Expected<void> write_page(const std::string& path, std::string blank, const Page& page) {
  auto filled = fill_page(std::move(blank), page);
  if (!filled) return fail(ExitStatus::NotThere, "template: " + filled.error());
  if (filled->size() > kLargestPage)
    return fail(ExitStatus::NotThere,
                fmt::format("{}: the page would have {:.1f} MB, more than {:.0f} MB: record less, see --max-MB of "
                            "axisctl record start",
                            path, static_cast<double>(filled->size()) / kMegabyte,
                            static_cast<double>(kLargestPage) / kMegabyte));
  return write_whole(path, *filled);
}

Expected<void> check_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path{path}.parent_path();
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return {};
  return not_written(path, error ? error.value() : ENOTDIR);
}

Expected<void> write_whole(const std::string& path, std::string_view content) {
  std::error_code error;
  std::filesystem::path target{path};
  const auto present = std::filesystem::status(target, error);
  if (std::filesystem::is_directory(present)) return not_written(path, EISDIR);
  if (std::filesystem::exists(present) && !std::filesystem::is_regular_file(present))
    return fail(ExitStatus::Failed, path + ": cannot be written: Not a regular file");
  if (std::filesystem::exists(present)) target = std::filesystem::canonical(target, error);
  const std::string part = fmt::format("{}.{}.part", target.string(), ::getpid());
  const os::Descriptor file{::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kReadable)};
  if (!file) return not_written(path, errno);
  int failed = write_all(file, content);
  if (failed == 0 && std::rename(part.c_str(), target.c_str()) != 0) failed = errno;
  if (failed == 0) return {};
  ::unlink(part.c_str());
  return not_written(path, failed);
}

}  // namespace axisctl
