#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/log.hpp"

namespace axisd {

/// How sure a write is.
enum class Durability : std::uint8_t {
  OnDisk,     ///< done when it outlives a power cut of this computer (fsync)
  InTheCache  ///< outlives this process; the computer writes it to the disk when it likes
};

/// A file that holds what outlives this process. It is replaced as a whole: whoever reads it, after whatever end
/// of a writer, finds the former content or the new one. Errors are one line of the log.
class StateFile {
 public:
  /// The file @p name in @p folder, which exists.
  StateFile(const std::filesystem::path& folder, const std::string& name, const Log& log);

  /// Its content; nothing if there is no file. One that cannot be read is set aside.
  std::optional<std::vector<std::byte>> read() const;
  /// Replaces its content; false if it could not, and the former content is still there then. Allocates nothing.
  [[nodiscard]] bool write(std::span<const std::byte> content, Durability durability) const noexcept;
  /// It cannot be used, because of @p reason: renamed to the first free one of NAME.bad, NAME.bad.1, ...
  void set_aside(std::string_view reason) const;

  const std::string& path() const noexcept { return path_; }

 private:
  bool fail(const char* what, int error) const noexcept;

  const Log& log_;
  std::string folder_;
  std::string path_;
  std::string temporary_;
};

}  // namespace axisd
