#include "eds/transform/comparison.hpp"

#include <gtest/gtest.h>

#include "tests/eds/corpus.hpp"
#include "tests/eds/sheet/read_sheet.hpp"

namespace eds {
namespace {

/// Every difference of two files, a line each.
std::string differences(const std::string& first, const std::string& second) {
  const ReadSheet one{first}, other{second};
  std::string text;
  for (const Difference& difference : compare(one.sheet, other.sheet)) text += to_text(difference) + "\n";
  return text;
}

/// The plain file of the corpus with @p from as @p to.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = corpus_file("good/plain.eds");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Comparison, FindsNothingBetweenAFileAndItself) {
  for (const char* const file : {"good/plain.eds", "good/modular.eds", "generated/axisd-unit.eds"})
    EXPECT_EQ(differences(corpus_file(file), corpus_file(file)), "");
}

TEST(Comparison, ComparesNumbersByValue) {
  const std::string plain = corpus_file("good/plain.eds");

  EXPECT_EQ(differences(plain, changed("HighLimit=1000", "HighLimit=0x3E8")), "");
  EXPECT_EQ(differences(plain, changed("DataType=0x000F", "DataType=15")), "");
  EXPECT_EQ(differences(plain, changed("AccessType=rww", "AccessType=RWW")), "");
  EXPECT_EQ(differences(plain, changed("DefaultValue=$NODEID+0x200", "DefaultValue=512 + $NODEID")), "");
  EXPECT_EQ(differences(plain, changed("CreatedBy=somebody", "CreatedBy=another")), "");
}

TEST(Comparison, NamesEveryAttributeThatDiffers) {
  const std::string plain = corpus_file("good/plain.eds");

  EXPECT_EQ(differences(plain, changed("HighLimit=1000", "HighLimit=1001")), "2000h:00 HighLimit: 1000 -> 1001\n");
  EXPECT_EQ(differences(plain, changed("HighLimit=1000\n", "")), "2000h:00 HighLimit: 1000 -> nothing\n");
  EXPECT_EQ(differences(plain, changed("DefaultValue=$NODEID+0x200", "DefaultValue=0x200")),
            "1400h:01 DefaultValue: $NODEID+0x200 -> 0x200\n");
  EXPECT_EQ(differences(plain, changed("ParameterName=Step", "ParameterName=Stride")),
            "2000h:00 ParameterName: Step -> Stride\n");
  EXPECT_EQ(differences(plain, changed("AccessType=rww", "AccessType=wo")), "2000h:00 AccessType: rww -> wo\n");
  EXPECT_EQ(differences(plain, changed("ObjFlags=0x3", "ObjFlags=1")), "2004h:00 ObjFlags: 0x3 -> 1\n");
  EXPECT_EQ(differences(plain, changed("BaudRate_800=0", "BaudRate_800=1")), "DeviceInfo BaudRate_800: 0 -> 1\n");
  EXPECT_EQ(differences(plain, changed("NrOfRXPDO=1", "NrOfRXPDO=2")), "DeviceInfo NrOfRXPDO: 1 -> 2\n");
}

TEST(Comparison, NamesWhatIsInOneFileOnly) {
  const std::string plain = corpus_file("good/plain.eds");
  const std::string without = changed("[2003sub2]", "[Elsewhere]");

  EXPECT_EQ(differences(plain, without), "2003h:02: only in the first file\n");
  EXPECT_EQ(differences(without, plain), "2003h:02: only in the second file\n");
  EXPECT_EQ(differences(plain, changed("[2001]", "[2009]")),
            "2001h: only in the first file\n2009h: only in the second file\n");
}

TEST(Comparison, ComparesModules) {
  std::string other = corpus_file("good/modular.eds");
  const std::string name = "ParameterName=Interrupt enable";
  other.replace(other.find(name), name.size(), "ParameterName=Interrupt");

  EXPECT_EQ(differences(corpus_file("good/modular.eds"), other),
            "M1 6005h:00 ParameterName: Interrupt enable -> Interrupt\n");
}

}  // namespace
}  // namespace eds
