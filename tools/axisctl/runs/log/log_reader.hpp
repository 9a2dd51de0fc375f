#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "libcanopen/base/frame.hpp"
#include "record/log_lines.hpp"
#include "record/reader.hpp"
#include "tools/axisctl/connection/failure.hpp"

namespace runs {

using axisctl::ExitStatus;
using axisctl::Expected;
using axisctl::fail;

/// Who has sent a frame, as far as the log says it.
enum class Sender : std::uint8_t { Unknown, Unit, Others };

/// A frame of a log.
struct LoggedFrame {
  std::chrono::nanoseconds at{};  ///< since 1970, or since whatever the log counts from
  std::uint64_t place = 0;        ///< number of its line, or of its record, from 1
  canopen::Frame frame{};         ///< of an error frame the identifier is the class of the error
  bool is_error = false;
  Sender sender = Sender::Unknown;

  /// True if both are the same frame, whenever they came.
  [[nodiscard]] bool is_same_frame(const LoggedFrame& other) const noexcept {
    return frame == other.frame && is_error == other.is_error;
  }
};

/// "605#4000100000000000", as `candump -l` writes it.
[[nodiscard]] std::string text_of(const LoggedFrame& logged);

/// The frames of a log of candump, of what candump has printed, or of a recording, one after the other.
class LogReader {
 public:
  /// Opens the file @p path. @p interface: the frames of that one; if it is empty, all have to be of one.
  [[nodiscard]] static Expected<std::unique_ptr<LogReader>> open(const std::string& path,
                                                                 std::string interface = {});

  /// The next frame, nothing at the end. ExitStatus::Damaged with line, what was expected and what is there.
  [[nodiscard]] Expected<std::optional<LoggedFrame>> next();

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// A recording, whose places are those of records; else of lines.
  [[nodiscard]] bool is_recording() const noexcept { return recording_.has_value(); }
  /// False if lines have no time: LoggedFrame::at is 0 then. Known with the first frame.
  [[nodiscard]] bool has_times() const noexcept { return has_times_; }
  /// Frames that are missing, as far as a recording says so.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  /// What is to be said of how it ends, in a line: that it is cut; empty if nothing is.
  [[nodiscard]] const std::string& remark() const noexcept { return remark_; }

 private:
  LogReader(std::string path, std::string interface) : path_{std::move(path)}, interface_{std::move(interface)} {}

  [[nodiscard]] Expected<void> open_recording();
  [[nodiscard]] Expected<std::optional<LoggedFrame>> next_line();
  [[nodiscard]] std::optional<LoggedFrame> next_record();

  std::string path_, interface_, remark_;
  bool is_chosen_ = false, has_times_ = true;
  std::uint64_t frames_ = 0, records_ = 0, lost_ = 0;
  std::optional<record::LogLines> lines_{};
  std::string content_;  ///< of a recording, which is in memory as a whole
  std::optional<record::Reader> recording_{};
  std::chrono::nanoseconds begin_{};  ///< of a recording, since 1970
};

}  // namespace runs
