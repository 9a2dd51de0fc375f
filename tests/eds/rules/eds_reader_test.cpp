#include "tests/eds/rules/eds_reader.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace eds_test {
namespace {

TEST(EdsReader, RefusesWhatIsNotSectionEntryOrEmptyLine) {
  for (const std::string_view text : {"[A\n", "a=1\n", "[A]\nb\n", "[A]\nb=1 \n", "[A]\r\n", "[A]"})
    EXPECT_THROW(read_eds(text), std::runtime_error) << text;
}

TEST(EdsReader, RefusesWhatStandsTwice) {
  EXPECT_THROW(read_eds("[A]\n[A]\n"), std::runtime_error);
  EXPECT_THROW(read_eds("[A]\nb=1\nb=2\n"), std::runtime_error);
}

TEST(EdsReader, FindsEntriesOfVariablesAndOfRecords) {
  const EdsFile file = read_eds("[1000]\nObjectType=0x7\n\n[1003]\nSubNumber=0x2\n\n[1003subA]\nObjectType=0x7\n");

  EXPECT_NE(find_entry(file, 0x1000, 0), nullptr);
  EXPECT_NE(find_entry(file, 0x1003, 0x0A), nullptr);
  EXPECT_EQ(find_entry(file, 0x1000, 1), nullptr);
  EXPECT_EQ(find_entry(file, 0x1003, 0), nullptr);
}

TEST(EdsReader, ReadsNumbersOfEveryForm) {
  EXPECT_EQ(number("-1"), -1);
  EXPECT_EQ(number("0xFF"), 255);
  EXPECT_EQ(number("$NODEID+0x600", 5), 0x605);
  EXPECT_EQ(number(""), std::nullopt);
  EXPECT_EQ(number("SINAMICS"), std::nullopt);
}

}  // namespace
}  // namespace eds_test
