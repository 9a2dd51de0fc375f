#include "daemon/log.hpp"

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include <poll.h>
#include <sys/stat.h>
#include <systemd/sd-journal.h>
#include <unistd.h>

namespace axisd {
namespace {

/// systemd names device and inode of the journal's stream in JOURNAL_STREAM; a redirected standard error differs.
bool standard_error_is_the_journal() noexcept {
  const char* const stream = std::getenv("JOURNAL_STREAM");
  struct stat status {};
  if (stream == nullptr || fstat(STDERR_FILENO, &status) != 0) return false;
  return std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino) == stream;
}

/// False if writing a line to @p descriptor would wait for a reader: the drive does not.
bool takes_a_line(int descriptor) noexcept {
  pollfd wanted{descriptor, POLLOUT, 0};
  return poll(&wanted, 1, 0) == 1 && (wanted.revents & POLLOUT) != 0;
}

}  // namespace

Log::Log(LogLevel level) noexcept : level_{level}, to_journal_{standard_error_is_the_journal()} {}

void Log::write(LogLevel level, fmt::string_view text, fmt::format_args arguments) const {
  if (level > level_) return;
  fmt::memory_buffer line;  // on the stack for any line of usual length
  fmt::vformat_to(std::back_inserter(line), text, arguments);
  const auto length = static_cast<int>(line.size());
  if (to_journal_) {
    sd_journal_send("MESSAGE=%.*s", length, line.data(), "PRIORITY=%i", static_cast<int>(level), nullptr);
  } else if (takes_a_line(STDERR_FILENO)) {
    std::fprintf(stderr, "axisd: %.*s\n", length, line.data());
  }
}

}  // namespace axisd
