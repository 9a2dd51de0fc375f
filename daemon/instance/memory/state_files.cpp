#include "daemon/instance/memory/state_files.hpp"

#include <cerrno>
#include <cstring>
#include <iterator>

#include <fcntl.h>
#include <sys/stat.h>

#include "os/descriptor.hpp"
#include "os/disk.hpp"

namespace axisd {
namespace {

/// Far above every image of a unit (bytes).
constexpr std::size_t kLongestFile = std::size_t{16} << 20;

using Outcome = tl::expected<void, WriteFailure>;

tl::unexpected<WriteFailure> failed(const char* what, int error) noexcept {
  return tl::unexpected{WriteFailure{what, error}};
}

/// 0 or the error.
int write_all(int descriptor, std::span<const std::byte> content) noexcept {
  while (!content.empty()) {
    const ssize_t written = os::disk().write(descriptor, content);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    content = content.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Creates @p path, which is nobody else's: what an interrupted writer has left there goes first.
int write_file(const char* path, std::span<const std::byte> content, Durability durability) noexcept {
  constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;
  os::Disk& disk = os::disk();
  if (disk.unlink(path) != 0 && errno != ENOENT) return errno;
  const os::Descriptor file{disk.open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kOwnerOnly)};
  if (!file) return errno;
  if (const int error = write_all(file.get(), content)) return error;
  return durability == Durability::OnDisk && disk.flush(file.get()) != 0 ? errno : 0;
}

/// How the new file has got its name.
enum class Replaced : std::uint8_t {
  Nothing,    ///< there was none before
  Exchanged,  ///< the former one has the temporary name now
  Over        ///< the former one is gone: the file system cannot exchange names
};

tl::expected<Replaced, int> give_name(const char* temporary, const char* path) noexcept {
  os::Disk& disk = os::disk();
  if (disk.exchange(temporary, path) == 0) return Replaced::Exchanged;
  const Replaced outcome = errno == ENOENT ? Replaced::Nothing : Replaced::Over;
  if (disk.rename(temporary, path) != 0) return tl::unexpected{errno};
  return outcome;
}

/// The former content has the name @p path again; false if that cannot be.
bool take_back(Replaced replaced, const char* temporary, const char* path) noexcept {
  if (replaced == Replaced::Nothing) return os::disk().unlink(path) == 0;
  return replaced == Replaced::Exchanged && os::disk().rename(temporary, path) == 0;
}

}  // namespace

StateFile::StateFile(const std::filesystem::path& folder, const std::string& name, const Log& log)
    : log_{log}, folder_{folder}, path_{folder / name}, temporary_{path_ + ".new"} {}

tl::expected<std::optional<std::vector<std::byte>>, std::string> StateFile::read() const {
  const auto content = os::disk().read(path_, kLongestFile);
  if (!content && content.error().is_missing()) return std::nullopt;
  if (!content) return tl::unexpected{content.error().reason()};
  const auto bytes = std::as_bytes(std::span{*content});
  return std::vector<std::byte>{bytes.begin(), bytes.end()};
}

Outcome StateFile::write(std::span<const std::byte> content, Durability durability) const noexcept {
  Outcome outcome{};
  if (const int error = write_file(temporary_.c_str(), content, durability)) {
    outcome = failed("cannot be written", error);
  } else if (durability == Durability::OnDisk) {
    outcome = replace_on_disk();
  } else if (os::disk().rename(temporary_.c_str(), path_.c_str()) != 0) {
    outcome = failed("cannot be replaced", errno);
  }
  if (!outcome) os::disk().unlink(temporary_.c_str());
  return outcome;
}

/// The new name outlives a power cut too, or the former content has it: a folder that cannot be flushed may not
/// leave behind what was called a failure.
Outcome StateFile::replace_on_disk() const noexcept {
  const os::Descriptor folder{os::disk().open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0)};
  if (!folder) return failed("cannot be written: its folder cannot be opened", errno);
  const auto replaced = give_name(temporary_.c_str(), path_.c_str());
  if (!replaced) return failed("cannot be replaced", replaced.error());
  const int error = os::disk().flush(folder.get()) == 0 ? 0 : errno;
  if (error != 0 && take_back(*replaced, temporary_.c_str(), path_.c_str()))
    return failed("cannot be written: its folder cannot be flushed", error);
  if (*replaced == Replaced::Exchanged) os::disk().unlink(temporary_.c_str());
  return {};
}

tl::expected<void, WriteFailure> StateFile::make_room() const noexcept {
  if (!os::disk().exists(path_.c_str())) return {};
  Name name;
  if (const int error = move_aside(".old", name)) return failed("cannot be set aside", error);
  log_.notice("{}: kept as {}", path_, name.data());
  return {};
}

void StateFile::report(const WriteFailure& failure) const noexcept {
  log_.error("{}: {}: {}", path_, failure.what, std::strerror(failure.error));
}

tl::expected<std::string, std::string> StateFile::set_aside(std::string_view suffix) const {
  Name name;
  if (const int error = move_aside(suffix, name)) return tl::unexpected{std::string{std::strerror(error)}};
  return std::string{name.data()};
}

/// 0 or the error; @p name is the first free one then.
int StateFile::move_aside(std::string_view suffix, Name& name) const noexcept {
  int number = 0;
  do {
    name.clear();
    fmt::format_to(std::back_inserter(name), "{}{}", path_, suffix);
    if (number != 0) fmt::format_to(std::back_inserter(name), ".{}", number);
    name.push_back('\0');
    ++number;
  } while (os::disk().exists(name.data()));
  return os::disk().rename(path_.c_str(), name.data()) == 0 ? 0 : errno;
}

}  // namespace axisd
