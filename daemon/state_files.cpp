#include "daemon/state_files.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bus/descriptor.hpp"

namespace axisd {
namespace {

/// Longer than every file that this program writes.
constexpr std::size_t kLongest = 16U << 20;

/// 0 or the error.
int write_all(int descriptor, std::span<const std::byte> content) noexcept {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    content = content.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

int write_file(const char* path, std::span<const std::byte> content, Durability durability) noexcept {
  constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;
  const bus::Descriptor file{::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kOwnerOnly)};
  if (!file) return errno;
  if (const int error = write_all(file.get(), content)) return error;
  return durability == Durability::OnDisk && ::fsync(file.get()) != 0 ? errno : 0;
}

/// The new name of a file in @p folder outlives a power cut.
int flush_folder(const char* folder) noexcept {
  const bus::Descriptor descriptor{::open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  return !descriptor || ::fsync(descriptor.get()) != 0 ? errno : 0;
}

/// Reads to the end; the error in @p error, else 0.
std::vector<std::byte> read_all(int descriptor, int& error) {
  std::vector<std::byte> content;
  while (true) {
    constexpr std::size_t kBlock = 65536;
    const std::size_t before = content.size();
    content.resize(before + kBlock);
    const ssize_t got = ::read(descriptor, &content[before], kBlock);
    content.resize(before + static_cast<std::size_t>(got > 0 ? got : 0));
    if (got < 0 && errno == EINTR) continue;
    error = got < 0 ? errno : content.size() > kLongest ? EFBIG : 0;
    if (got <= 0 || error != 0) return content;
  }
}

}  // namespace

StateFile::StateFile(const std::filesystem::path& folder, const std::string& name, const Log& log)
    : log_{log}, folder_{folder}, path_{folder / name}, temporary_{path_ + ".new"} {}

std::optional<std::vector<std::byte>> StateFile::read() const {
  const bus::Descriptor file{::open(path_.c_str(), O_RDONLY | O_CLOEXEC)};
  if (!file && errno == ENOENT) return std::nullopt;
  int error = file ? 0 : errno;
  std::vector<std::byte> content = file ? read_all(file.get(), error) : std::vector<std::byte>{};
  if (error == 0) return content;
  set_aside(fmt::format("cannot be read: {}", std::strerror(error)));
  return std::nullopt;
}

bool StateFile::write(std::span<const std::byte> content, Durability durability) const noexcept {
  if (const int error = write_file(temporary_.c_str(), content, durability)) {
    ::unlink(temporary_.c_str());
    return fail("cannot be written", error);
  }
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) return fail("cannot be replaced", errno);
  if (durability == Durability::InTheCache) return true;
  const int error = flush_folder(folder_.c_str());
  return error == 0 || fail("is written, but its folder cannot be flushed", error);
}

bool StateFile::fail(const char* what, int error) const noexcept {
  log_.error("{}: {}: {}", path_, what, std::strerror(error));
  return false;
}

void StateFile::set_aside(std::string_view reason) const {
  std::string aside = path_ + ".bad";
  for (int number = 1; ::access(aside.c_str(), F_OK) == 0; ++number)
    aside = fmt::format("{}.bad.{}", path_, number);
  const bool moved = ::rename(path_.c_str(), aside.c_str()) == 0;
  const std::string where =
      moved ? "kept as " + aside : fmt::format("cannot be set aside: {}", std::strerror(errno));
  log_.warning("{}: {}; {}, the unit starts without it", path_, reason, where);
}

}  // namespace axisd
