#pragma once

#include <cstddef>

namespace preload {

/// Notes of the environment what a program needs to live by the bus's time; before the process has threads.
void note_environment() noexcept;

/// The environment of a program that a process by turns becomes or starts: one that was made anew has again what
/// makes it take part, as else all would wait for it. Variables that it sets stay as they are.
class ProgramEnvironment {
 public:
  /// @p given, which outlives this; nullptr is one without variables.
  explicit ProgramEnvironment(char* const* given) noexcept;
  ProgramEnvironment(const ProgramEnvironment&) = delete;
  ProgramEnvironment& operator=(const ProgramEnvironment&) = delete;
  ~ProgramEnvironment();

  [[nodiscard]] char* const* entries() const noexcept { return added_ == nullptr ? given_ : added_; }

 private:
  char* const* given_;
  char** added_ = nullptr;  ///< neither on a stack that may be short nor from malloc(3), which a child of fork(2)
                            ///< must not call
  std::size_t size_ = 0;    ///< of that (bytes)
};

}  // namespace preload
