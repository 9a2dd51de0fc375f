#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace audit_tool_test {

/// A transfer that is right.
inline constexpr const char* kRight =
    "(1.000000) can0 605#4000100000000000\n"
    "(1.000500) can0 585#4300100092010200\n";
/// sdo.overlap, an error.
inline constexpr const char* kOverlap =
    "(1.000000) can0 605#4000100000000000\n"
    "(1.000200) can0 605#4001100000000000\n";
/// sdo.abort-alone, a warning.
inline constexpr const char* kAbortAlone =
    "(1.000000) can0 605#2B17100064000000\n"
    "(1.000500) can0 585#6017100000000000\n"
    "(1.001000) can0 605#8017100000000405\n";

/// A transfer and @p count aborts behind it, each of which is one too many.
inline std::string aborts(int count) {
  std::string log = kRight;
  for (int i = 0; i < count; ++i) log += "(" + std::to_string(i + 2) + ".000000) can0 605#8000100000000405\n";
  return log;
}

/// Runs of canopen-audit over files in a folder of their own.
class AuditRun : public testing::Test {
 protected:
  /// The path of a file with @p text.
  std::string write(const std::string& name, std::string_view text) const {
    std::ofstream{folder_.path(name), std::ios::binary} << text;
    return folder_.path(name);
  }
  /// A run with @p words; paths in what it says are without the folder.
  fakes::Finished run(std::vector<std::string> words) const {
    words.insert(words.begin(), CANOPEN_AUDIT);
    fakes::Finished finished = fakes::run_program(words);
    finished.output = shown(std::move(finished.output));
    finished.errors = shown(std::move(finished.errors));
    return finished;
  }
  /// A run over a log x.log with @p text.
  fakes::Finished audit(std::string_view text, std::vector<std::string> words = {}) const {
    words.insert(words.begin(), write("x.log", text));
    return run(std::move(words));
  }
  /// The JSON report of such a run.
  nlohmann::json report(std::string_view text, std::vector<std::string> words = {}) const {
    words.insert(words.end(), {"--json", folder_.path("x.json")});
    const fakes::Finished finished = audit(text, std::move(words));
    EXPECT_EQ(finished.errors, "");
    return nlohmann::json::parse(std::ifstream{folder_.path("x.json")}, nullptr, false);
  }
  std::string shown(std::string text) const {
    const std::string path = folder_.path() + '/';
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path))
      text.erase(at, path.size());
    return text;
  }

  fakes::TemporaryDirectory folder_;
};

}  // namespace audit_tool_test
