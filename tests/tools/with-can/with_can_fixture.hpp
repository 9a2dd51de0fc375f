#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace with_can_test {

/// Runs with-can in a folder of its own.
class WithCan : public testing::Test {
 protected:
  /// Runs `with-can WORDS...` with a bare environment and @p more (NAME=VALUE).
  [[nodiscard]] static fakes::Finished run(std::vector<std::string> words,
                                           const std::vector<std::string>& more = {}) {
    words.insert(words.begin(), WITH_CAN);
    std::vector<std::string> environment{"PATH=/usr/bin:/bin"};
    environment.insert(environment.end(), more.begin(), more.end());
    return fakes::run_program(words, environment);
  }
  /// The same with a bus in the folder.
  [[nodiscard]] fakes::Finished run_on_bus(const std::vector<std::string>& command) const {
    std::vector<std::string> words{"--bus", path("bus"), "--"};
    words.insert(words.end(), command.begin(), command.end());
    return run(words);
  }
  [[nodiscard]] std::string path(const std::string& file) const { return folder_.path(file); }

  /// An executable file with @p content.
  [[nodiscard]] std::string executable(const std::string& name, const std::string& content) const {
    std::ofstream{path(name), std::ios::binary} << content;
    std::filesystem::permissions(path(name), std::filesystem::perms::owner_all);
    return path(name);
  }
  /// The program /bin/true with the bytes at @p offset replaced by @p bytes.
  [[nodiscard]] std::string changed_program(std::size_t offset, const std::string& bytes) const {
    return executable("changed", whole_program().replace(offset, bytes.size(), bytes));
  }
  [[nodiscard]] static std::string whole_program() {
    std::ifstream file{"/bin/true", std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
  }

 private:
  fakes::TemporaryDirectory folder_;
};

/// Whether @p text is one line in which @p part is.
inline testing::AssertionResult is_one_line_with(const std::string& text, const std::string& part) {
  const bool one_line = !text.empty() && text.find('\n') == text.size() - 1;
  if (one_line && text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "expected one line with \"" << part << "\", got: " << text;
}

}  // namespace with_can_test
