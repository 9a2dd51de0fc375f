#include "eds/transform/dictionary_source.hpp"

#include <gtest/gtest.h>

#include "libcanopen/od/dictionary.hpp"
#include "tests/eds/corpus.hpp"
#include "tests/eds/sheet/read_sheet.hpp"
#include "tests/eds/transform/plain_objects.hpp"
#include "tests/eds/transform/types_objects.hpp"

namespace eds {
namespace {

/// The header for the file "good/NAME.eds" of the corpus.
std::string header_of(const std::string& name, std::string_view table, std::string expected_findings = "") {
  const ReadSheet read{corpus_file("good/" + name + ".eds"), name + ".eds"};
  Findings findings{name + ".eds"};
  std::string text = write_dictionary(read.sheet, {.table = table, .origin = name + ".eds"}, findings);
  EXPECT_EQ(checks_of(findings), expected_findings);
  return text;
}

std::string kept(const char* file) {
  return content_of(std::filesystem::path{SOURCE_FOLDER} / "tests/eds/transform" / file);
}

TEST(DictionarySource, IsTheTableThatTheseTestsAreBuiltWith) {
  EXPECT_EQ(header_of("plain", "kPlainObjects"), kept("plain_objects.hpp"));
  EXPECT_EQ(header_of("types", "kTypesObjects"), kept("types_objects.hpp"));
}

TEST(DictionarySource, GivesADictionaryWithTheDefaultsOfTheFile) {
  const canopen::Dictionary dictionary{kPlainObjects, 5};

  EXPECT_EQ(dictionary.entries().size(), 39U);
  EXPECT_EQ(dictionary.stored(0x1018, 1), 0x1F0);
  EXPECT_EQ(dictionary.stored(0x1400, 1), 0x205) << "the node-ID is added";
  EXPECT_EQ(dictionary.stored(0x2002, 3), -1) << "an entry of CompactSubObj";
  EXPECT_FALSE(dictionary.lookup(0x2001, 0)->writable);
  EXPECT_TRUE(dictionary.lookup(0x2000, 0)->receive_mappable);
  EXPECT_FALSE(dictionary.lookup(0x2000, 0)->transmit_mappable);
}

TEST(DictionarySource, KeepsLimits) {
  canopen::Dictionary dictionary{kPlainObjects, 5};

  EXPECT_TRUE(dictionary.write(*dictionary.lookup(0x2002, 1), 100));
  EXPECT_EQ(dictionary.write(*dictionary.lookup(0x2002, 1), 101).error(), canopen::AbortCode::ValueTooHigh);
  EXPECT_EQ(dictionary.write(*dictionary.lookup(0x2002, 1), -101).error(), canopen::AbortCode::ValueTooLow);
}

TEST(DictionarySource, KnowsEveryTypeOfTheStandard) {
  const canopen::Dictionary dictionary{kTypesObjects, 5};
  const auto text = [&](std::uint16_t index) {
    const auto bytes = dictionary.text(*dictionary.lookup(index, 0));
    return std::string{bytes.begin(), bytes.end()};
  };

  EXPECT_EQ(dictionary.stored(0x2002, 0), -128);
  EXPECT_EQ(dictionary.stored(0x2004, 0), -2147483648LL);
  EXPECT_EQ(dictionary.stored(0x2008, 0), 0xC4BB8000) << "-1500 as REAL32";
  EXPECT_EQ(text(0x2009), "any text; with anything=in it");
  EXPECT_EQ(text(0x200A), "\x01\x02\xFF");
  EXPECT_EQ(dictionary.stored(0x2015, 0), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(dictionary.stored(0x201B, 0), -1) << "all bits of UNSIGNED64";
}

TEST(DictionarySource, LeavesOutWhatHasNoSimpleType) {
  const ReadSheet read{"[2000]\nDataType=0x21\nParameterName=x\nAccessType=rw\n"};
  Findings findings{"a.eds"};

  const std::string text = write_dictionary(read.sheet, {.origin = "a.eds"}, findings);

  EXPECT_EQ(text.find("0x2000"), std::string::npos);
  EXPECT_EQ(checks_of(findings), "data-type:2");
}

TEST(DictionarySource, EscapesNames) {
  const ReadSheet read{
      "[2000]\nDataType=5\nParameterName=\"\\\xE4"
      "1\" \?\?/\nAccessType=rw\n"};
  Findings findings{"a.eds"};

  EXPECT_NE(write_dictionary(read.sheet, {.origin = "a.eds"}, findings).find(R"(.name = "\"\\\3441\" \?\?/")"),
            std::string::npos);
}

}  // namespace
}  // namespace eds
