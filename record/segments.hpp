#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "record/format.hpp"
#include "record/output_file.hpp"

namespace record {

/// The files of one recording: a recording and the candump log beside it, of bounded size. Every function that
/// writes gives 0 or an errno; where() then says where.
///
/// A recording that goes on has two halves, NAME.axrec and, older, NAME.1.axrec. One that is made by faults has
/// NAME-1.axrec to NAME-10.axrec, the oldest of which makes room.
class Segments {
 public:
  static constexpr unsigned kHalves = 2;
  static constexpr unsigned kFaults = 10;

  struct Plan {
    std::filesystem::path folder;  ///< made if it is not there; the one above it exists
    std::string name;
    std::string head;                       ///< JSON
    std::string interface;                  ///< as the log names it
    std::chrono::nanoseconds wall_clock{};  ///< since 1970, at the start of the unit
    std::uint64_t most_bytes = 0;           ///< of all files of the recording together
    bool by_faults = false;
  };

  explicit Segments(Plan plan);

  /// Begins the next file.
  [[nodiscard]] int open() noexcept;
  bool is_open() const noexcept { return recording_.is_open(); }
  /// Whether the open file has room for @p record.
  bool has_room(std::span<const std::byte> record) const noexcept;
  /// Adds @p record, which has no checksum yet.
  [[nodiscard]] int write(std::span<const std::byte> record) noexcept;
  [[nodiscard]] int flush() noexcept;
  /// Ends the open file.
  [[nodiscard]] int close(EndReason reason, Moment at) noexcept;
  /// Leaves the open file as it is.
  void abandon() noexcept;

  /// The file that was opened last, or the folder that could not be made.
  const std::string& where() const noexcept { return where_; }
  /// Bytes of the open file.
  std::uint64_t size() const noexcept { return recording_.size() + log_.size(); }

 private:
  std::string path(const std::string& suffix, const char* extension) const;
  std::string fault_suffix() const;
  int open_files(const std::string& suffix) noexcept;
  int write_head() noexcept;

  Plan plan_;
  std::uint64_t share_;  ///< most bytes of one file
  std::string where_;
  OutputFile recording_;
  OutputFile log_;
};

}  // namespace record
