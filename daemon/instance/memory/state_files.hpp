#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "service/log.hpp"

namespace axisd {

/// How sure a write is.
enum class Durability : std::uint8_t {
  OnDisk,     ///< done when it outlives a power cut of this computer (fsync)
  InTheCache  ///< outlives this process; the computer writes it to the disk when it likes
};

/// Why a file was not written.
struct WriteFailure {
  const char* what;
  int error;  ///< errno
};

/// A file that holds what outlives this process. It is replaced as a whole: whoever reads it, after whatever end
/// of a writer, finds the former content or the new one. What it has to tell is one line of the log.
class StateFile {
 public:
  /// The file @p name in @p folder, which exists.
  StateFile(const std::filesystem::path& folder, const std::string& name, const Log& log);

  /// Its content, nothing if there is no file; or why it cannot be read.
  tl::expected<std::optional<std::vector<std::byte>>, std::string> read() const;
  /// Replaces its content. After a failure the next read() finds the former one, after success the new one.
  /// Allocates nothing and logs nothing: any thread may do it, one at a time.
  [[nodiscard]] tl::expected<void, WriteFailure> write(std::span<const std::byte> content,
                                                       Durability durability) const noexcept;
  /// Keeps what there is as NAME.old (see set_aside()) and logs where. Any thread may do it, as write().
  [[nodiscard]] tl::expected<void, WriteFailure> make_room() const noexcept;
  /// Logs @p failure.
  void report(const WriteFailure& failure) const noexcept;
  /// Renames it to the first free one of NAME@p suffix, NAME@p suffix.1, ...; returns where it is now, or why it
  /// is where it was.
  tl::expected<std::string, std::string> set_aside(std::string_view suffix) const;

  const std::string& path() const noexcept { return path_; }

 private:
  using Name = fmt::memory_buffer;  // on the stack, of a usual path

  int move_aside(std::string_view suffix, Name& name) const noexcept;
  tl::expected<void, WriteFailure> replace_on_disk() const noexcept;

  const Log& log_;
  std::string folder_;
  std::string path_;
  std::string temporary_;
};

}  // namespace axisd
