#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace with_can {

/// What came of looking for the program to run or into it.
struct Verdict {
  int status = 0;       ///< 0: it can be run; else with-can's exit status
  std::string message;  ///< what is wrong and what to use instead
};

/// Exit status: nothing can be preloaded into the program.
inline constexpr int kUnfit = 2;
/// Exit status: there is such a file, but it cannot be executed (as of a shell).
inline constexpr int kNotExecutable = 126;
/// Exit status: there is no such program (as of a shell).
inline constexpr int kNotFound = 127;

/// A program as execvp(3) would find it.
struct FoundProgram {
  std::filesystem::path path;
  Verdict verdict;
};

/// Looks for @p name, in the folders of $PATH if it has no slash.
FoundProgram find_program(std::string_view name);

/// Whether a library that was built as this program is can be preloaded into @p path. Scripts are followed to what
/// interprets them.
Verdict judge_program(const std::filesystem::path& path);

}  // namespace with_can
