#include "eds/document/value.hpp"

#include <gtest/gtest.h>

namespace eds {
namespace {

std::string read(std::string_view text) {
  const auto number = parse_integer(text);
  if (!number) return "none";
  return (number->node_relative ? "node+" : "") + to_text(number->value);
}

TEST(IntegerText, TakesEveryFormOfTheStandardAndOfTheWild) {
  const std::array<std::array<const char*, 2>, 19> cases{{{"0", "0"},
                                                          {"10", "10"},
                                                          {"0x1f", "31"},
                                                          {"0X1F", "31"},
                                                          {"010", "8"},
                                                          {"00", "0"},
                                                          {"-5", "-5"},
                                                          {"-0x10", "-16"},
                                                          {"+7", "7"},
                                                          {"-0", "0"},
                                                          {" 12 ", "12"},
                                                          {"$NODEID+0x200", "node+512"},
                                                          {"$nodeid + 512", "node+512"},
                                                          {"0x200+$NODEID", "node+512"},
                                                          {"0x200 + $NodeId", "node+512"},
                                                          {"$NODEID", "node+0"},
                                                          {"18446744073709551615", "18446744073709551615"},
                                                          {"0xFFFFFFFFFFFFFFFF", "18446744073709551615"},
                                                          {"-9223372036854775808", "-9223372036854775808"}}};
  for (const auto& [text, value] : cases) EXPECT_EQ(read(text), value) << text;
}

TEST(IntegerText, RefusesEverythingElse) {
  for (const char* const text : {"",
                                 " ",
                                 "-",
                                 "+",
                                 "0x",
                                 "x10",
                                 "08",
                                 "1 2",
                                 "12a",
                                 "0xG",
                                 "--1",
                                 "++1",
                                 "1+1",
                                 "$NODEID+",
                                 "+$NODEID",
                                 "$NODEID-1",
                                 "$NODEID+$NODEID",
                                 "$NODEID*2",
                                 "18446744073709551616",
                                 "0x10000000000000000",
                                 "1.0"})
    EXPECT_EQ(read(text), "none") << text;
}

TEST(IntegerText, TellsASumFromTheNodeIdAlone) {
  EXPECT_TRUE(parse_integer("$NODEID+0")->sum);
  EXPECT_FALSE(parse_integer("$NODEID")->sum);
}

TEST(Integer, HasTheOrderOfNumbers) {
  const auto value = [](const char* text) { return parse_integer(text)->value; };

  EXPECT_LT(value("-2"), value("-1"));
  EXPECT_LT(value("-1"), value("0"));
  EXPECT_LT(value("0"), value("0xFFFFFFFFFFFFFFFF"));
}

/// A value of a data type, and what is read of it: the number, or why it is none.
struct Case {
  unsigned type;
  const char* text;
  const char* expected;
};

std::string read(const Case& row) {
  const auto value = parse_value(row.text, *find_data_type(row.type));
  if (!value) return value.error().out_of_range ? "range" : "form";
  if (value->kind == ValueKind::Real) return std::to_string(value->real);
  if (value->kind == ValueKind::Text || value->kind == ValueKind::Bytes) return "text " + value->text;
  return to_text(value->integer);
}

TEST(Value, IsReadAsItsTypeSays) {
  const std::array cases{
      Case{0x01, "1", "1"},
      Case{0x01, "2", "range"},
      Case{0x02, "-128", "-128"},
      Case{0x02, "-129", "range"},
      Case{0x02, "0xFF", "-1"},
      Case{0x02, "0x80", "-128"},
      Case{0x02, "128", "range"},
      Case{0x02, "0x100", "range"},
      Case{0x04, "0x80000000", "-2147483648"},
      Case{0x05, "255", "255"},
      Case{0x05, "256", "range"},
      Case{0x05, "-1", "range"},
      Case{0x05, "$NODEID+0x80", "128"},
      Case{0x05, "$NODEID+0x81", "range"},
      Case{0x06, "abc", "form"},
      Case{0x08, "-1.5", "-1.500000"},
      Case{0x08, "2e3", "2000.000000"},
      Case{0x08, "0x3F800000", "1.000000"},
      Case{0x08, "0x3F80000000", "range"},
      Case{0x08, "0x7FC00000", "range"},
      Case{0x08, "1e39", "range"},
      Case{0x08, "1,5", "form"},
      Case{0x08, "", "form"},
      Case{0x08, "nan", "range"},
      Case{0x11, "1e3", "1000.000000"},
      Case{0x11, "0x3FF0000000000000", "1.000000"},
      Case{0x09, "any text", "text any text"},
      Case{0x0A, "01 AB ff", "text 01 AB ff"},
      Case{0x0A, "01A", "form"},
      Case{0x0A, "0 1A", "form"},
      Case{0x0F, "xy", "form"},
      Case{0x0C, "281474976710655", "281474976710655"},
      Case{0x0C, "281474976710656", "range"},
      Case{0x10, "0xFFFFFF", "-1"},
      Case{0x15, "-9223372036854775808", "-9223372036854775808"},
      Case{0x15, "0xFFFFFFFFFFFFFFFF", "-1"},
      Case{0x15, "9223372036854775808", "range"},
      Case{0x16, "0x1000000", "range"},
      Case{0x1A, "0xFFFFFFFFFFFFFF", "72057594037927935"},
      Case{0x1B, "18446744073709551615", "18446744073709551615"},
      Case{0x1B, "$NODEID+18446744073709551615", "range"},
  };
  for (const Case& row : cases) EXPECT_EQ(read(row), row.expected) << row.type << ' ' << row.text;
}

TEST(Value, SaysWhatWasExpected) {
  EXPECT_EQ(parse_value("300", *find_data_type(0x05)).error().expected, "a value of UNSIGNED8 (0..255)");
  EXPECT_EQ(parse_value("x", *find_data_type(0x02)).error().expected, "a value of INTEGER8 (-128..127)");
}

TEST(Value, IsOrderedForEveryNode) {
  const auto value = [](const char* text) { return *parse_value(text, *find_data_type(0x07)); };

  EXPECT_TRUE(ordered(value("0x200"), value("$NODEID+0x200")));
  EXPECT_FALSE(ordered(value("$NODEID+0x200"), value("0x27E")));
  EXPECT_TRUE(ordered(value("$NODEID+0x200"), value("0x27F")));
}

TEST(DataTypes, AreThoseOfCia301) {
  EXPECT_EQ(find_data_type(0x1B)->name, "UNSIGNED64");
  EXPECT_EQ(find_data_type(0x10)->bits, 24);
  for (const unsigned number : {0x00U, 0x0EU, 0x17U, 0x1CU, 0x20U, 0x10007U})
    EXPECT_EQ(find_data_type(number), nullptr) << number;
}

}  // namespace
}  // namespace eds
