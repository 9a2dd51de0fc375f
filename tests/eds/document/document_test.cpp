#include "eds/document/document.hpp"

#include <gtest/gtest.h>

namespace eds {
namespace {

struct Read {
  Findings findings{"a.eds"};
  Document document;

  explicit Read(std::string_view text) : document{read_document(text, findings)} {}

  /// Every finding as its check and line.
  [[nodiscard]] std::string found() const {
    std::string list;
    for (const Finding& finding : findings.all())
      list += (list.empty() ? "" : " ") + std::string{finding.check} + ":" + std::to_string(finding.line);
    return list;
  }
};

TEST(Document, GivesBackWhatItWasRead) {
  for (const std::string_view text :
       {std::string_view{""}, std::string_view{"\n"}, std::string_view{"[a]"},
        std::string_view{"[a]\r\nb = c \r\n"},
        std::string_view{"\xEF\xBB\xBF; x\n[A]\r\n\tk=\xE4\n\n[a]\rrubbish"}, std::string_view{"=\n[\n]\n[]"},
        std::string_view{"a\0b=\0\n", 6}, std::string_view{"\xFF\xFE[\0a\0]\0", 8}})
    EXPECT_EQ(Read{text}.document.write(), text);
}

TEST(Document, FindsSectionsAndKeysInAnyLetterCase) {
  const Read read{"[FILEINFO]\n fileName = x.eds \n[1018SUB0]\nk=v"};

  EXPECT_EQ(read.document.value("FileInfo", "FileName"), "x.eds");
  EXPECT_EQ(read.document.value("1018sub0", "K"), "v");
  EXPECT_EQ(read.document.find("1018sub0")->name(), "1018SUB0") << "the spelling stays";
  EXPECT_EQ(read.document.find("1018sub1"), nullptr);
  EXPECT_EQ(read.found(), "");
}

TEST(Document, SetsAValueAndKeepsTheRest) {
  Read read{"[A] \r\n; note\r\nKey =  old  \r\n\r\n[B]\r\nc=d"};

  read.document.find("a")->set("KEY", "new one");
  read.document.find("a")->set("More", "1");
  read.document.find("b")->set("e", "f");

  EXPECT_EQ(read.document.write(), "[A] \r\n; note\r\nKey =  new one  \r\nMore=1\r\n\r\n[B]\r\nc=d\r\ne=f");
}

TEST(Document, AddsASectionAfterABlankLine) {
  Read read{"[A]\nb=c"};
  read.document.section("New").set("k", "v");
  EXPECT_EQ(read.document.write(), "[A]\nb=c\n\n[New]\nk=v\n");

  Document empty;
  empty.section("New").set("k", "v");
  EXPECT_EQ(empty.write(), "[New]\r\nk=v\r\n");
}

TEST(Document, RemovesEntriesAndSections) {
  Read read{"; head\n[A]\nk=1\nl=2\nK=3\n\n[M1]\na=b\n[B]\n"};

  EXPECT_TRUE(read.document.find("A")->remove("k"));
  EXPECT_FALSE(read.document.find("A")->remove("k"));
  read.document.remove_sections([](std::string_view name) { return name == "M1"; });

  EXPECT_EQ(read.document.write(), "; head\n[A]\nl=2\n\n[B]\n");
  EXPECT_EQ(read.document.find("M1"), nullptr);
  EXPECT_NE(read.document.find("B"), nullptr);
}

TEST(Document, ReportsEveryWrongLineAndGoesOn) {
  EXPECT_EQ(Read{"a=b\n[A\n[]\n[A]x\nno entry\n=v\n"}.found(),
            "entry-outside-section:1 section-form:2 section-form:3 section-form:4 line-form:5 line-form:6");
  EXPECT_EQ(Read{"# note\n"}.found(), "comment-form:1");
  EXPECT_EQ(Read{"[A]\n" + std::string(256, ';')}.found(), "line-length:2");
}

TEST(Document, ReportsWhatStandsTwiceWithBothLines) {
  const Read read{"[A]\nk=1\nK=2\n[B]\n[a]\nk=3\n"};

  EXPECT_EQ(read.found(), "duplicate-section:5 duplicate-key:3");
  EXPECT_EQ(to_text(read.findings.all()[0]),
            "a.eds:5: error: [a]: expected the section once, it stands in line 1 already, got [a] "
            "(duplicate-section)");
  EXPECT_EQ(to_text(read.findings.all()[1]),
            "a.eds:3: error: [A] K: expected the key once, it stands in line 2 already, got K=2 (duplicate-key)");
  EXPECT_EQ(read.document.value("a", "k"), "1") << "the first one counts";
}

TEST(Document, ReportsEncodingAndLineEndsOnce) {
  EXPECT_EQ(Read{"\xEF\xBB\xBF[A]\n"}.found(), "byte-order-mark:1");
  EXPECT_EQ(Read{"[A]\nk=\xE4\nl=\xE4\n"}.found(), "encoding:2");
  EXPECT_EQ(Read{"[A]\r\nk=1\nl=2\n"}.found(), "line-ending:2");
  EXPECT_EQ(Read{std::string_view("\xFF\xFE[\0", 4)}.found(), "encoding:1");
  EXPECT_EQ(Read{std::string_view("[A]\nk=\0", 7)}.found(), "encoding:2");
}

TEST(Document, KnowsItsEncoding) {
  EXPECT_EQ(Read{"[A]"}.document.encoding(), Encoding::Ascii);
  EXPECT_EQ(Read{"[A]\nk=\xC3\xA4"}.document.encoding(), Encoding::Utf8);
  EXPECT_EQ(Read{"[A]\nk=\xE4"}.document.encoding(), Encoding::Latin1);
}

TEST(Finding, IsPrintable) {
  EXPECT_EQ(printable("\xE4\t\x7F\xC3\xA4"), "\xC3\xA4\\x09\\x7F\xC3\xA4");
  EXPECT_EQ(printable(std::string(200, 'x')), std::string(120, 'x') + "...");
}

TEST(Finding, LeavesOutWhatIsNotThere) {
  EXPECT_EQ(to_text(Finding{.severity = Severity::Warning,
                            .check = "c",
                            .file = "f",
                            .section = "",
                            .key = "",
                            .expected = "x",
                            .found = "y"}),
            "f: warning: expected x, got y (c)");
}

}  // namespace
}  // namespace eds
