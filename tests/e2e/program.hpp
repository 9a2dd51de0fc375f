#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

#include "os/descriptor.hpp"

namespace e2e {

/// How long a test waits for something that should come at once; software emulation and busy machines are slow.
inline constexpr std::chrono::seconds kPatience{30};

/// A program that runs beside the test, with its output and its errors in one text. It ends with the test.
class Program {
 public:
  /// Starts @p arguments (the program first) with @p environment (NAME=VALUE) and nothing else in its environment;
  /// WATCHDOG_PID is added if WATCHDOG_USEC is in it. Throws std::system_error.
  Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  /// Kills the program if it still runs.
  ~Program();

  pid_t id() const noexcept { return id_; }
  /// Sends @p signal.
  void signal(int signal) const noexcept;
  /// Whether the program ends within @p patience; its exit status stays for wait().
  bool ends_within(std::chrono::milliseconds patience) const;
  /// Waits until the program has ended: its exit status, or the negative number of the signal that ended it.
  /// Throws std::runtime_error if it goes on.
  int wait();
  /// Waits until the output contains @p text, at or behind position @p from; false if nothing more comes in @p
  /// patience.
  bool wait_for_output(std::string_view text, std::size_t from = 0,
                       std::chrono::milliseconds patience = kPatience);
  /// All that was written so far.
  const std::string& output();
  /// Processor time used so far, in clock ticks.
  std::uint64_t processor_ticks() const;
  /// Waits until the program has gone to sleep @p times times more; false if it does not in time.
  bool wakes(std::uint64_t times) const;

 private:
  std::uint64_t sleeps() const;
  bool read_some(std::chrono::milliseconds patience);

  pid_t id_ = -1;
  os::Descriptor pipe_;
  std::string output_;
  bool ended_ = false;
};

}  // namespace e2e
