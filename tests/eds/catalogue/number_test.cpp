#include "eds/catalogue/number.hpp"

#include <gtest/gtest.h>

namespace eds {
namespace {

TEST(Number, ReadsDecimalHexadecimalAndNodeRelativeForms) {
  EXPECT_EQ(parse_number("-2147483648")->value, -2147483648LL);
  EXPECT_EQ(parse_number("0xC00006DF")->value, 0xC00006DF);
  EXPECT_EQ(parse_number("$NODEID+0x580")->at(127), 0x5FF);
  EXPECT_EQ(parse_number("0x10")->at(127), 0x10);
}

TEST(Number, RefusesEverythingElse) {
  for (const std::string_view text :
       {"", "0x", "12a", "0x1FFFFFFFF", " 1", "$NODEID", "$NODEID+", "$NODEID+-1", "--1", "+1"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(Number, ReadsDecimalNumbersAsReals) {
  EXPECT_EQ(parse_real("-200.50")->real, -200.5);
  EXPECT_EQ(parse_real("3")->text, "3");
  for (const std::string_view text : {"", "0x10", "1e3", "1.0 ", "inf"}) EXPECT_FALSE(parse_real(text)) << text;
}

TEST(Number, ReadsHexadecimalDigitsOfOneLength) {
  EXPECT_EQ(parse_hexadecimal("16FF", 4), 0x16FFU);
  for (const std::string_view text : {"", "16", "016FF", "0x16", "16G0"})
    EXPECT_FALSE(parse_hexadecimal(text, 4)) << text;
}

TEST(Number, RangeHoldsForEveryNodeId) {
  const Range byte = *range_of(canopen::DataType::Unsigned8);

  EXPECT_TRUE(within(*parse_number("$NODEID+0x80"), byte));
  EXPECT_FALSE(within(*parse_number("$NODEID+0x81"), byte));
}

TEST(Number, RangesAreThoseOfTheTypes) {
  EXPECT_EQ(range_of(canopen::DataType::Integer8)->low, -128);
  EXPECT_EQ(range_of(canopen::DataType::Integer16)->high, 32767);
  EXPECT_EQ(range_of(canopen::DataType::Unsigned32)->high, 0xFFFFFFFF);
  EXPECT_EQ(range_of(canopen::DataType::Boolean)->high, 1);
  EXPECT_FALSE(range_of(canopen::DataType::VisibleString));
  EXPECT_FALSE(range_of(canopen::DataType::Real32));
}

}  // namespace
}  // namespace eds
