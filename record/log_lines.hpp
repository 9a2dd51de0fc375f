#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace record {

/// The lines of a log, one after the other; the log may be of any length.
class LogLines {
 public:
  /// Opens the file @p path; or why it cannot be read, in one line.
  [[nodiscard]] static tl::expected<LogLines, std::string> open(const std::string& path);

  /// Goes to the next line; false at the end, and if it cannot be read, which failure() says.
  bool next();
  /// The line without its end; of one that is too long, its beginning.
  [[nodiscard]] std::string_view text() const noexcept { return {line_.data(), length_}; }
  /// True for blanks alone.
  [[nodiscard]] bool is_blank() const noexcept;
  /// From 1.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
  /// More characters than a line of candump can have.
  [[nodiscard]] bool is_too_long() const noexcept { return is_too_long_; }
  /// The file ends within the line.
  [[nodiscard]] bool is_open() const noexcept { return is_open_; }
  /// Why there are no more lines, in one line; empty at the end of the file.
  [[nodiscard]] std::string failure() const;
  /// "PATH:12: expected THIS, got "...""; what a terminal would obey is left out.
  [[nodiscard]] std::string complaint(std::string_view expected) const;

 private:
  explicit LogLines(const std::string& path) : path_{path}, file_{path} {}

  /// Longest line that is looked at (bytes): twice what a frame takes.
  static constexpr std::size_t kLongestLine = 256;

  std::string path_;
  std::ifstream file_;
  std::array<char, kLongestLine + 1> line_{};
  std::size_t length_ = 0;
  std::uint64_t number_ = 0;
  bool is_too_long_ = false, is_open_ = false;
};

/// What is said of a line that is_too_long().
inline constexpr std::string_view kLineRule = "a line of at most 256 characters";

}  // namespace record
