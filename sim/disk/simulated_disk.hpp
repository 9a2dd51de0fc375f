#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "os/disk.hpp"
#include "sim/base/draw.hpp"

namespace sim {

/// What goes wrong with one operation of a disk.
enum class DiskFailure : std::uint8_t {
  NoSpace,     ///< it fails with ENOSPC, and of a write half is done before
  InputError,  ///< it fails with EIO; what was written and not flushed is lost
  ShortWrite,  ///< of a write half is done, without an error
  PowerCut,    ///< the power fails before it; it and all that follow do nothing
};

/// The disk of one computer, as POSIX lets it be: what was written is there for those who read, and outlives a
/// power cut for certain only when file and folder were flushed. What was not flushed is kept, lost or torn, and
/// names change in any order, as chance decides.
class SimulatedDisk final : public os::Disk {
 public:
  explicit SimulatedDisk(Draw draw) noexcept : draw_{draw} {}

  /// The @p nth operation from now on (1 = the next) that changes something, or flushes it, has @p failure.
  void fail(DiskFailure failure, std::uint64_t nth) noexcept;
  /// Operations so far that changed something, or flushed it.
  [[nodiscard]] std::uint64_t operations() const noexcept { return operations_; }
  /// The next @p count reads fail with EIO.
  void fail_reads(unsigned count) noexcept { failing_reads_ = count; }
  /// Nothing fails any more.
  void mend() noexcept {
    failing_operation_ = 0;
    failing_reads_ = 0;
  }

  /// The power is off from now on: all operations fail and change nothing.
  void cut_power() noexcept;
  [[nodiscard]] bool has_power() const noexcept { return has_power_; }
  /// The power is back: what is on the disk is what has outlived the cut.
  void return_power();

  /// What a reader would find at @p path, as a number that no other content has; nothing if there is no such file.
  [[nodiscard]] std::optional<std::uint64_t> fingerprint(const std::string& path) const;
  /// All contents that @p path has been given since the beginning, as such numbers.
  [[nodiscard]] const std::vector<std::uint64_t>& contents_given(const std::string& path) const;

  // os::Disk
  int open(const char* path, int flags, mode_t mode) noexcept override;
  ssize_t write(int descriptor, std::span<const std::byte> content) noexcept override;
  int flush(int descriptor) noexcept override;
  int rename(const char* from, const char* to) noexcept override;
  int exchange(const char* one, const char* other) noexcept override;
  int unlink(const char* path) noexcept override;
  bool exists(const char* path) noexcept override;
  tl::expected<std::string, os::UnreadableFile> read(const std::string& path, std::size_t most) override;

 private:
  struct File {
    std::vector<std::byte> cached;   ///< as readers find it
    std::vector<std::byte> flushed;  ///< outlives a power cut
  };
  using Folder = std::map<std::string, std::shared_ptr<File>, std::less<>>;
  /// A change of names that was not flushed: afterwards these names stand for these files, nullptr: for none.
  struct Renaming {
    std::vector<std::pair<std::string, std::shared_ptr<File>>> names;
  };

  [[nodiscard]] int begin_operation() noexcept;
  static std::uint64_t fingerprint_of(const File& file) noexcept;
  [[nodiscard]] std::shared_ptr<File> find(std::string_view path) const;
  void apply(Renaming renaming);
  static void apply(const Renaming& renaming, Folder& folder);
  void settle(File& file);

  Draw draw_;
  Folder names_;          ///< as readers find them
  Folder flushed_names_;  ///< outlive a power cut
  std::vector<Renaming> unflushed_;
  std::map<std::string, std::vector<std::uint64_t>, std::less<>> given_;
  std::map<int, std::shared_ptr<File>> open_;  ///< nullptr: a folder
  std::uint64_t operations_ = 0;
  std::uint64_t failing_operation_ = 0;  ///< 0: none
  DiskFailure failure_ = DiskFailure::NoSpace;
  unsigned failing_reads_ = 0;
  bool has_power_ = true;
};

}  // namespace sim
