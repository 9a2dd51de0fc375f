#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>
#include <tl/expected.hpp>

namespace scenario {

/// What is started.
struct Command {
  std::vector<std::string> words;
  std::vector<std::pair<std::string, std::string>> environment{};  ///< over that of this program
  std::string log{};                                               ///< file for what it prints
};

/// A child in a process group of its own. It dies with this program, whatever ends that.
class Process {
 public:
  /// Starts @p command; the error is one line.
  [[nodiscard]] static tl::expected<Process, std::string> start(const Command& command);
  Process(Process&& other) noexcept
      : process_{std::exchange(other.process_, 0)}, ended_{other.ended_}, log_{std::move(other.log_)} {}
  Process& operator=(Process&&) = delete;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  /// Ends it and everything in its group.
  ~Process() { stop(); }

  [[nodiscard]] pid_t identifier() const noexcept { return process_; }
  /// Its exit status, of a signal 128 and the number of it, as a shell says it; nothing while it runs.
  std::optional<int> ended() noexcept;
  void signal(int number) const noexcept;
  /// SIGTERM, and SIGKILL to those who do not care.
  void stop() noexcept;
  /// The last line that it has printed, for messages.
  [[nodiscard]] std::string last_line() const;
  [[nodiscard]] const std::string& log() const noexcept { return log_; }

 private:
  Process(pid_t process, std::string log) : process_{process}, log_{std::move(log)} {}

  pid_t process_ = 0;
  std::optional<int> ended_{};
  std::string log_;
};

}  // namespace scenario
