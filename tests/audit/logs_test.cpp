// Logs of masters in tests/audit/logs: those in right/ do nothing wrong, those in wrong/RULE/ break that rule and
// no other.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/audit/heard_log.hpp"

namespace audit_test {
namespace {

namespace fs = std::filesystem;

fs::path log_folder() {
  return fs::path{SOURCE_FOLDER} / "tests/audit/logs";
}

std::string text_of(const fs::path& log) {
  std::ifstream file{log};
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::vector<fs::path> logs_in(const char* name) {
  std::vector<fs::path> logs;
  for (const auto& entry : fs::recursive_directory_iterator{log_folder() / name})
    if (entry.path().extension() == ".log") logs.push_back(entry.path());
  std::ranges::sort(logs);
  return logs;
}

std::string name_of_log(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem();
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
}

class RightLogTest : public testing::TestWithParam<fs::path> {};

TEST_P(RightLogTest, HasNoFinding) {
  EXPECT_EQ(rules_of(findings_of(text_of(GetParam()))), std::vector<std::string_view>{});
}
INSTANTIATE_TEST_SUITE_P(Logs, RightLogTest, testing::ValuesIn(logs_in("right")), name_of_log);

class WrongLogTest : public testing::TestWithParam<fs::path> {};

TEST_P(WrongLogTest, BreaksTheRuleOfItsFolderAlone) {
  const std::string rule = GetParam().parent_path().filename();
  EXPECT_EQ(rules_of(findings_of(text_of(GetParam()))), std::vector<std::string_view>{rule});
}
INSTANTIATE_TEST_SUITE_P(Logs, WrongLogTest, testing::ValuesIn(logs_in("wrong")), name_of_log);

}  // namespace
}  // namespace audit_test
