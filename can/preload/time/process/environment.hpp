#pragma once

#include <cstddef>

namespace preload {

/// Notes of the environment what a program needs to live by the bus's time; before the process has threads.
void note_environment() noexcept;

/// The environment of a program that a process by turns becomes or starts: one that was made anew has again what
/// makes it take part, as else all would wait for it. Variables that it sets stay as they are.
class ProgramEnvironment {
 public:
  /// @p given, which outlives this, may be nullptr.
  explicit ProgramEnvironment(char* const* given) noexcept;

  [[nodiscard]] char* const* entries() const noexcept { return entries_; }

 private:
  /// Beyond that nothing is added.
  static constexpr std::size_t kMost = 4096;

  char* const* entries_;
  char* added_[kMost];
};

}  // namespace preload
