#include "eds/lint/lint.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "eds/lint/check_table.hpp"
#include "tests/eds/corpus.hpp"
#include "tests/eds/sheet/read_sheet.hpp"

namespace eds {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = fs::path{SOURCE_FOLDER} / "tests/data/eds";

/// The data sheets of @p folder, without what is known of them beside.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator{folder})
    if (entry.path().extension() == ".eds" || entry.path().extension() == ".dcf")
      files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

/// The findings of the file @p path, a line each.
std::string report(const fs::path& path) {
  return lint_report(content_of(path), path.filename().string());
}

std::string name_of(const testing::TestParamInfo<std::string>& file) {
  std::string name = fs::path{file.param}.stem().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

class RightFile : public testing::TestWithParam<std::string> {};

TEST_P(RightFile, HasNoFinding) {
  EXPECT_EQ(report(GetParam()), "");
}

TEST_P(RightFile, IsWrittenAsItWasRead) {
  const std::string text = content_of(GetParam());
  EXPECT_EQ(ReadSheet{text}.document.write(), text);
}

INSTANTIATE_TEST_SUITE_P(Generated, RightFile, testing::ValuesIn(files_in(GENERATED_EDS_FOLDER)), name_of);
INSTANTIATE_TEST_SUITE_P(Corpus, RightFile, testing::ValuesIn(files_in(kCorpus / "good")), name_of);

/// A file beside which stands what must be found in it.
class WrongFile : public testing::TestWithParam<std::string> {};

TEST_P(WrongFile, HasExactlyTheFindingsBesideIt) {
  EXPECT_EQ(report(GetParam()), content_of(fs::path{GetParam()}.replace_extension(".txt")));
}

TEST_P(WrongFile, IsWrittenAsItWasRead) {
  const std::string text = content_of(GetParam());
  EXPECT_EQ(ReadSheet{text}.document.write(), text);
}

INSTANTIATE_TEST_SUITE_P(Corpus, WrongFile, testing::ValuesIn(files_in(kCorpus / "wrong")), name_of);
INSTANTIATE_TEST_SUITE_P(Wild, WrongFile, testing::ValuesIn(files_in(kCorpus / "wild")), name_of);

/// The check that a file of the corpus is named after: "sub-count" of "sub-count.eds" and "sub-count_2.eds".
std::string check_of(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem.substr(0, stem.find('_'));
}

class OneMistake : public testing::TestWithParam<std::string> {};

TEST_P(OneMistake, IsFoundByTheCheckThatTheFileIsNamedAfterAndByNoOther) {
  const Findings findings = lint(content_of(GetParam()), fs::path{GetParam()}.filename().string());

  EXPECT_FALSE(findings.empty());
  for (const Finding& finding : findings.all()) EXPECT_EQ(finding.check, check_of(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Corpus, OneMistake, testing::ValuesIn(files_in(kCorpus / "wrong")), name_of);

TEST(Checks, HaveAFileEach) {
  std::set<std::string> checks, files;
  for (const Check& check : kChecks) checks.emplace(check.id);
  for (const std::string& file : files_in(kCorpus / "wrong")) files.insert(check_of(file));

  EXPECT_EQ(files, checks);
}

TEST(Checks, AreListedInTheDocumentation) {
  std::string table;
  for (const Check& check : kChecks)
    table += "| `" + std::string{check.id} + "` | " + std::string{check.rule} + " |\n";

  const std::string page = content_of(fs::path{SOURCE_FOLDER} / "docs/reference/eds-checks.md");
  std::string rows;
  std::istringstream lines{page};
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| `")) rows += line + "\n";
  EXPECT_EQ(rows, table);
}

TEST(Lint, FindsFiftyMistakesInOneFile) {
  std::string text = "[OptionalObjects]\n";
  for (int n = 0; n < 50; ++n) text += "x" + std::to_string(n) + "\n";

  EXPECT_EQ(std::ranges::count(lint(text, "a.eds").all(), "line-form", &Finding::check), 50);
}

TEST(Lint, SaysOfEveryFindingWhereItIsWhatIsThereAndWhatWasExpected) {
  for (const char* const folder : {"wrong", "wild"})
    for (const std::string& file : files_in(kCorpus / folder))
      for (const Finding& finding : lint(content_of(file), file).all()) {
        EXPECT_FALSE(finding.expected.empty()) << to_text(finding);
        EXPECT_FALSE(finding.found.empty()) << to_text(finding);
        EXPECT_TRUE(finding.line != 0 || finding.found == "nothing" || finding.found == "none")
            << to_text(finding);
      }
}

TEST(Lint, TakesAnEmptyFile) {
  EXPECT_EQ(checks_of(lint("", "a.eds")),
            "section-missing:0 section-missing:0 section-missing:0 section-missing:0 section-missing:0 "
            "section-missing:0 mandatory-object:0 mandatory-object:0 mandatory-object:0 mandatory-object:0");
}

}  // namespace
}  // namespace eds
