#include "sim/disk/simulated_disk.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fcntl.h>

namespace sim {
namespace {

int failed(int error) noexcept {
  errno = error;
  return -1;
}

}  // namespace

void SimulatedDisk::fail(DiskFailure failure, std::uint64_t nth) noexcept {
  failure_ = failure;
  failing_operation_ = operations_ + nth;
}

void SimulatedDisk::cut_power() noexcept {
  has_power_ = false;
}

/// The error of the operation that begins; 0: it is done.
int SimulatedDisk::begin_operation() noexcept {
  if (!has_power_) return EIO;
  if (++operations_ != failing_operation_) return 0;
  switch (failure_) {
    case DiskFailure::NoSpace:
      return ENOSPC;
    case DiskFailure::InputError:
      return EIO;
    case DiskFailure::ShortWrite:
      return 0;
    case DiskFailure::PowerCut:
      break;
  }
  cut_power();
  return EIO;
}

std::shared_ptr<SimulatedDisk::File> SimulatedDisk::find(std::string_view path) const {
  const auto found = names_.find(path);
  return found != names_.end() ? found->second : nullptr;
}

/// A descriptor of the system stands for the file, so that whoever has it can close it as ever.
int SimulatedDisk::open(const char* path, int flags, mode_t) noexcept {
  const bool creates = (flags & O_CREAT) != 0;
  if (const int error = creates ? begin_operation() : has_power_ ? 0 : EIO) return failed(error);
  if (creates && find(path)) return failed(EEXIST);
  const int descriptor = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return -1;
  auto file = creates ? std::make_shared<File>() : nullptr;
  if (file) apply(Renaming{{{path, file}}});
  open_[descriptor] = std::move(file);
  return descriptor;
}

ssize_t SimulatedDisk::write(int descriptor, std::span<const std::byte> content) noexcept {
  const int error = begin_operation();
  if (!has_power_) return failed(error);
  const bool is_cut_short = operations_ == failing_operation_ && content.size() > 1;
  File& file = *open_.at(descriptor);
  const auto part = is_cut_short ? content.first(content.size() / 2) : content;
  if (error == 0 || is_cut_short) file.cached.insert(file.cached.end(), part.begin(), part.end());
  return error != 0 ? failed(error) : static_cast<ssize_t>(part.size());
}

/// The system may forget what it could not write, and says so once.
int SimulatedDisk::flush(int descriptor) noexcept {
  const int error = begin_operation();
  const std::shared_ptr<File>& file = open_.at(descriptor);
  if (error != 0) {
    if (has_power_ && file && draw_.chance(0.5)) file->cached = file->flushed;
    return failed(error);
  }
  if (file) {
    file->flushed = file->cached;
    return 0;
  }
  flushed_names_ = names_;
  unflushed_.clear();
  return 0;
}

int SimulatedDisk::rename(const char* from, const char* to) noexcept {
  if (const int error = begin_operation()) return failed(error);
  auto file = find(from);
  if (!file) return failed(ENOENT);
  apply(Renaming{{{from, nullptr}, {to, std::move(file)}}});
  return 0;
}

int SimulatedDisk::exchange(const char* one, const char* other) noexcept {
  if (const int error = begin_operation()) return failed(error);
  auto first = find(one);
  auto second = find(other);
  if (!first || !second) return failed(ENOENT);
  apply(Renaming{{{one, std::move(second)}, {other, std::move(first)}}});
  return 0;
}

int SimulatedDisk::unlink(const char* path) noexcept {
  if (const int error = begin_operation()) return failed(error);
  if (!find(path)) return failed(ENOENT);
  apply(Renaming{{{path, nullptr}}});
  return 0;
}

bool SimulatedDisk::exists(const char* path) noexcept {
  return find(path) != nullptr;
}

tl::expected<std::string, os::UnreadableFile> SimulatedDisk::read(const std::string& path, std::size_t most) {
  using os::UnreadableFile;
  const auto file = find(path);
  if (!file) return tl::unexpected{UnreadableFile{UnreadableFile::Why::System, ENOENT}};
  if (failing_reads_ > 0 || !has_power_) {
    if (failing_reads_ > 0) --failing_reads_;
    return tl::unexpected{UnreadableFile{UnreadableFile::Why::System, EIO}};
  }
  if (file->cached.size() > most) return tl::unexpected{UnreadableFile{UnreadableFile::Why::TooLong, EFBIG}};
  std::string text(file->cached.size(), '\0');
  std::ranges::transform(file->cached, text.begin(), [](std::byte each) { return static_cast<char>(each); });
  return text;
}

/// FNV-1a.
std::uint64_t SimulatedDisk::fingerprint_of(const File& file) noexcept {
  constexpr std::uint64_t kBasis = 0xCBF2'9CE4'8422'2325, kPrime = 0x0000'0100'0000'01B3;
  std::uint64_t hash = kBasis;
  for (const std::byte each : file.cached) hash = (hash ^ std::to_integer<std::uint64_t>(each)) * kPrime;
  return hash;
}

std::optional<std::uint64_t> SimulatedDisk::fingerprint(const std::string& path) const {
  const auto file = find(path);
  return file ? std::optional{fingerprint_of(*file)} : std::nullopt;
}

const std::vector<std::uint64_t>& SimulatedDisk::contents_given(const std::string& path) const {
  static const std::vector<std::uint64_t> kNone;
  const auto found = given_.find(path);
  return found != given_.end() ? found->second : kNone;
}

void SimulatedDisk::apply(Renaming renaming) {
  apply(renaming, names_);
  for (const auto& [name, file] : renaming.names)
    if (file) given_[name].push_back(fingerprint_of(*file));
  unflushed_.push_back(std::move(renaming));
}

void SimulatedDisk::apply(const Renaming& renaming, Folder& folder) {
  for (const auto& [name, file] : renaming.names) {
    if (file) {
      folder[name] = file;
    } else {
      folder.erase(name);
    }
  }
}

/// What is left of what was not flushed: all, nothing, the beginning, or the whole length with a part of it zero.
void SimulatedDisk::settle(File& file) {
  if (file.cached == file.flushed) return;
  enum : std::uint8_t { All, Nothing, Beginning, Hole, kOutcomes };
  const std::uint64_t length = file.cached.size();
  switch (draw_.below(kOutcomes)) {
    case All:
      file.flushed = file.cached;
      break;
    case Beginning:
      file.flushed = file.cached;
      file.flushed.resize(draw_.below(length + 1));
      break;
    case Hole:
      file.flushed = file.cached;
      std::fill(file.flushed.begin() + static_cast<std::ptrdiff_t>(draw_.below(length + 1)), file.flushed.end(),
                std::byte{0});
      break;
    default:
      break;
  }
  file.cached = file.flushed;
}

/// A journal keeps the order of the names, so that a beginning of the changes is there; other file systems keep
/// none.
void SimulatedDisk::return_power() {
  const bool keeps_order = draw_.chance(0.5);
  const std::uint64_t kept = draw_.below(unflushed_.size() + 1);
  for (std::size_t i = 0; i < unflushed_.size(); ++i)
    if (keeps_order ? i < kept : draw_.chance(0.5)) apply(unflushed_[i], flushed_names_);
  unflushed_.clear();
  names_ = flushed_names_;
  for (const auto& [name, file] : names_) settle(*file);
  open_.clear();
  failing_operation_ = 0;
  has_power_ = true;
}

}  // namespace sim
