#include "eds/catalogue/catalogue.hpp"

#include <initializer_list>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "eds/writer/eds_writer.hpp"
#include "tests/eds/catalogue/catalogue_text.hpp"

namespace eds {
namespace {

TEST(Catalogue, ReadsRowsIntoObjects) {
  const Catalogue read = parse_catalogue(catalogue(variable(
      R"(, "pdo": true, "default": "0x10", "low": "1", "high": "0xFE", "limits": "owner", "obj_flags": 1)",
      "UNSIGNED8", "rww")));

  const Entry* const entry = find_entry(read.objects, 0x6000, 0);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->type, canopen::DataType::Unsigned8);
  EXPECT_EQ(entry->access, canopen::Access::ReadWriteWrite);
  EXPECT_TRUE(entry->pdo_mappable);
  EXPECT_TRUE(entry->default_stated);
  EXPECT_EQ(entry->initial.value, 0x10);
  EXPECT_EQ(entry->low->value, 1);
  EXPECT_EQ(entry->high->value, 0xFE);
  EXPECT_EQ(entry->limit_check, canopen::LimitCheck::Owner);
  EXPECT_EQ(entry->object_flags, 1U);
  EXPECT_EQ(read.objects.back().scope, Scope::Axis);
}

TEST(Catalogue, ExpandsARangeOfSubIndices) {
  const Catalogue read = parse_catalogue(catalogue(""));

  EXPECT_NE(find_entry(read.objects, 0x1018, 3), nullptr);
  EXPECT_EQ(find_entry(read.objects, 0x1018, 4), nullptr);
  EXPECT_EQ(find_entry(read.objects, 0x1019, 0), nullptr);
}

TEST(Catalogue, LetsAnEntryBeginWithWhatIsNoConstant) {
  const Catalogue read = parse_catalogue(catalogue(variable(R"(, "pdo": false, "start": "measured")")));

  const Entry* const entry = find_entry(read.objects, 0x6000, 0);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->start, "measured");
  EXPECT_EQ(entry->initial.value, 0);
  EXPECT_FALSE(entry->default_stated);
}

TEST(Catalogue, WritesEachSubIndexOfARangeAsItsOwnSection) {
  const Catalogue read = parse_catalogue(catalogue(""));
  const std::string text = write_eds(read, read.files.front());

  for (const char* section : {"[1018sub1]\n", "[1018sub2]\n", "[1018sub3]\n"})
    EXPECT_NE(text.find(section), std::string::npos) << section;
}

/// A broken catalogue and the whole message it must give.
struct Case {
  const char* name;
  std::string rows;
  std::string message;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class BrokenRow : public testing::TestWithParam<Case> {};

TEST_P(BrokenRow, IsRefusedWithRowFieldAndExpectation) {
  EXPECT_EQ(message_of(catalogue(GetParam().rows)), GetParam().message);
}

const std::string kRow = "row 6 (6000:00): ";
const std::string kPlain = R"(, "pdo": false, "default": "0")";

const Case kBrokenRows[] = {
    {"UnknownField", variable(kPlain + R"(, "colour": 1)"),
     kRow + "unknown field \"colour\": expected one of index, sub, object, type, access, pdo, default, value, "
            "start, other_axes, vector, several_axes, low, high, limits, obj_flags, unit, scope, name, does"},
    {"FieldOfAVariableInARecord", head("6000", "RECORD").insert(1, R"("type": "UNSIGNED8", )"),
     "row 6 (6000): unknown field \"type\": expected one of index, object, scope, name, does"},
    {"RowIsNoObject", "5", "row 6: expected an object, got 5"},
    {"FieldTwice", variable(kPlain + R"(, "sub": "00")"),
     "field \"sub\" stands twice in one object: expected it once"},
    {"MissingField", variable(R"(, "default": "0")"), kRow + "field \"pdo\": expected true or false, got nothing"},
    {"IndexForm", row("60", R"(, "object": "ARRAY")"),
     "row 6 (60): field \"index\": expected four hexadecimal digits, 1000 to FFFF, got \"60\""},
    {"SubForm", sub("6000", "0", "UNSIGNED8", "0"),
     "row 6 (6000:0): field \"sub\": expected two hexadecimal digits, 00 to FE, or a range as 02-52, got \"0\""},
    {"SubRangeBackwards", sub("6000", "05-02", "UNSIGNED8", "0"),
     "row 6 (6000:05-02): field \"sub\": expected two hexadecimal digits, 00 to FE, or a range as 02-52, got "
     "\"05-02\""},
    {"ObjectWord", head("6000", "LIST"),
     "row 6 (6000): field \"object\": expected one of VAR, ARRAY, RECORD, got \"LIST\""},
    {"TypeWord", variable(kPlain, "REAL64"),
     kRow + "field \"type\": expected one of BOOLEAN, INTEGER8, INTEGER16, INTEGER32, UNSIGNED8, UNSIGNED16, "
            "UNSIGNED32, "
            "REAL32, VISIBLE_STRING, got \"REAL64\""},
    {"AccessWord", variable(kPlain, "UNSIGNED8", "r"),
     kRow + "field \"access\": expected one of ro, wo, rw, rwr, rww, const, got \"r\""},
    {"LimitsWord", variable(kPlain + R"(, "low": "0", "limits": "nobody")"),
     kRow + "field \"limits\": expected one of table, owner, got \"nobody\""},
    {"LimitsWithoutLimit", variable(kPlain + R"(, "limits": "owner")"),
     kRow + "field \"limits\": expected \"low\" or \"high\" beside it, got \"owner\""},
    {"FlagsOutOfRange", variable(kPlain + R"(, "obj_flags": 4)"),
     kRow + "field \"obj_flags\": expected an integer 0 to 3, got 4"},
    {"DefaultNotRepresentable", variable(R"(, "pdo": false, "default": "256")"),
     kRow + "field \"default\": expected a number as text, 0 to 255, got \"256\""},
    {"DefaultNotRepresentableOnNode127", variable(R"(, "pdo": false, "default": "$NODEID+0x81")"),
     kRow + "field \"default\": expected a number as text, 0 to 255, got \"$NODEID+0x81\""},
    {"DefaultBelowSigned", variable(R"(, "pdo": false, "default": "-129")", "INTEGER8"),
     kRow + "field \"default\": expected a number as text, -128 to 127, got \"-129\""},
    {"DefaultNoNumber", variable(R"(, "pdo": false, "default": "many")"),
     kRow + "field \"default\": expected a number as text, 0 to 255, got \"many\""},
    {"DefaultMissing", variable(R"(, "pdo": false)"),
     kRow + "field \"value\": expected a number as text, 0 to 255, got nothing"},
    {"DefaultAndValue", variable(kPlain + R"(, "value": "1")"),
     kRow + "field \"value\": expected nothing beside \"default\", got \"1\""},
    {"StartBesideADefault", variable(kPlain + R"(, "start": "measured")"),
     kRow + "field \"start\": expected nothing beside \"default\" or \"value\", got \"measured\""},
    {"StartBelowLow", variable(R"(, "pdo": false, "start": "measured", "low": "1")"),
     kRow + "field \"start\": expected at least \"low\", got \"measured\""},
    {"LowAboveHigh", variable(R"(, "pdo": false, "default": "3", "low": "5", "high": "4")"),
     kRow + "field \"low\": expected at most \"high\", got \"5\""},
    {"DefaultBelowLow", variable(R"(, "pdo": false, "default": "3", "low": "5")"),
     kRow + "field \"default\": expected at least \"low\", got \"3\""},
    {"ValueAboveHigh", variable(R"(, "pdo": false, "value": "9", "high": "5")"),
     kRow + "field \"value\": expected at most \"high\", got \"9\""},
    {"HighNotRepresentable", variable(kPlain + R"(, "high": "0x100")"),
     kRow + "field \"high\": expected a number as text, 0 to 255, got \"0x100\""},
    {"LimitOfAString", variable(kPlain + R"(, "high": "5")", "VISIBLE_STRING"),
     kRow + "field \"high\": expected no limit for a string, got \"5\""},
    {"MovingLimitOfAWritableEntry", variable(kPlain + R"(, "high": "$NODEID+1")"),
     kRow + "field \"high\": expected a limit without $NODEID in a writable entry, got \"$NODEID+1\""},
    {"MappableString", variable(R"(, "pdo": true, "default": "a")", "VISIBLE_STRING", "ro"),
     kRow + "field \"pdo\": expected false for a string, got true"},
    {"MappableWithoutDirection", variable(R"(, "pdo": true, "default": "0")"),
     kRow + "field \"access\": expected ro, rwr, rww or wo for a mappable entry, got \"rw\""},
    {"NameEmpty", R"({"index": "6000", "object": "ARRAY", "scope": "axis", "name": ""})",
     "row 6 (6000): field \"name\": expected a text of printable ASCII, got \"\""},
    {"NameNotAscii", R"({"index": "6000", "object": "ARRAY", "scope": "axis", "name": "\u00e4"})",
     "row 6 (6000): field \"name\": expected a text of printable ASCII, got \"\xC3\xA4\""},
    {"SameEntryTwice", rows({variable(kPlain), sub("6001", "00", "UNSIGNED8", "0"), variable(kPlain)}),
     "row 8 (6000:00): field \"sub\": expected 6000:00 in one row only"},
    {"OverlappingRanges", sub("1018", "03-04", "UNSIGNED32", "0"),
     "row 6 (1018:03-04): field \"sub\": expected 1018:03 in one row only"},
    {"IndexOrder", rows({variable(kPlain), sub("5FFF", "00", "UNSIGNED8", "0")}),
     "row 7 (5FFF:00): field \"index\": expected rows in ascending order"},
    {"SecondHead", rows({head("6000", "ARRAY"), head("6000", "ARRAY")}),
     "row 7 (6000): field \"object\": expected the row before those of its sub-indices, once"},
    {"ScopesOfOneObject", sub("1018", "04", "UNSIGNED32", "0"),
     "row 6 (1018:04): field \"scope\": expected that of the object's first row"},
    {"VariableWithSubIndices", rows({variable(kPlain), sub("6000", "01", "UNSIGNED8", "0")}),
     "6000:00: expected one row with sub 00 for a VAR, or an ARRAY or RECORD row first"},
    {"VariableWithoutSubZero", sub("6000", "01", "UNSIGNED8", "0"),
     "6000:00: expected one row with sub 00 for a VAR, or an ARRAY or RECORD row first"},
    {"SubOrder",
     rows({head("6000", "RECORD"), sub("6000", "01", "UNSIGNED8", "0"), sub("6000", "00", "UNSIGNED8", "1")}),
     "6000:00: expected rows in ascending order of \"sub\""},
    {"EmptyRecord", head("6000", "RECORD"), "6000:00: expected rows for sub 00 and at least one more"},
    {"TypeOfSubZero",
     rows({head("6000", "RECORD"), sub("6000", "00", "UNSIGNED16", "1"), sub("6000", "01", "UNSIGNED8", "0")}),
     "6000:00: expected type UNSIGNED8"},
    {"HighestSubIndex",
     rows({head("6000", "RECORD"), sub("6000", "00", "UNSIGNED8", "2"), sub("6000", "01", "UNSIGNED8", "0")}),
     "6000:00: expected the highest sub-index 1 as default, got 2"},
    {"CountAboveHighestSubIndex",
     rows(
         {head("6000", "RECORD"), sub("6000", "00", "UNSIGNED8", "2", "rw"), sub("6000", "01", "UNSIGNED8", "0")}),
     "6000:00: expected at most the highest sub-index 1 as default, got 2"},
    {"ArrayOfTwoTypes",
     rows({head("6000", "ARRAY"), sub("6000", "00", "UNSIGNED8", "2"), sub("6000", "01", "UNSIGNED8", "0"),
           sub("6000", "02", "UNSIGNED16", "0")}),
     "6000:02: expected the type of sub-index 1, an array has one type"},
    {"ArrayWithAGap",
     rows({head("6000", "ARRAY"), sub("6000", "00", "UNSIGNED8", "2"), sub("6000", "02", "UNSIGNED8", "0")}),
     "6000:01: expected a row, the array has a gap"},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, BrokenRow, testing::ValuesIn(kBrokenRows),
                         [](const auto& broken) { return std::string{broken.param.name}; });

std::string mapping(const std::string& object, const std::string& mapped) {
  return rows({head(object, "RECORD"), sub(object, "00", "UNSIGNED8", "1", "rw"),
               sub(object, "01", "UNSIGNED32", mapped, "rw"),
               variable(R"(, "pdo": true, "default": "0")", "UNSIGNED8", "rww")});
}

TEST(Catalogue, RefusesAMappingThatCannotWork) {
  EXPECT_EQ(message_of(catalogue(mapping("1600", "0x60000008"))), "accepted");
  EXPECT_EQ(message_of(catalogue(mapping("1600", "0x60010008"))), "1600:01: expected a mappable entry as default");
  EXPECT_EQ(message_of(catalogue(mapping("1600", "0x60000010"))),
            "1600:01: expected the length of the mapped entry, in bits");
  EXPECT_EQ(message_of(catalogue(mapping("1A00", "0x60000008"))),
            "1A00:01: expected an entry that may be mapped in this direction");
}

TEST(Catalogue, RefusesAMappingOfMoreThan64Bits) {
  const std::string nine = rows({head("1A00", "RECORD"), sub("1A00", "00", "UNSIGNED8", "9", "rw"),
                                 sub("1A00", "01-09", "UNSIGNED32", "0x60000008", "rw"),
                                 variable(R"(, "pdo": true, "default": "0")", "UNSIGNED8", "ro")});

  EXPECT_EQ(message_of(catalogue(nine)), "1A00:00: expected at most 64 mapped bits, got 72");
}

TEST(Catalogue, RefusesAMissingMandatoryObject) {
  EXPECT_EQ(message_of(whole(kFiles, kOffsets, "", "")), "1000:00: expected a row for this mandatory entry");
}

TEST(Catalogue, RefusesWhatIsNotACatalogue) {
  EXPECT_EQ(message_of("{").substr(0, 9), "not JSON:");
  EXPECT_EQ(message_of("[]"), "catalogue: expected an object, got []");
  EXPECT_EQ(message_of("{}"), "catalogue: field \"header\": expected an object, got nothing");
  EXPECT_EQ(message_of(R"({"header": 1, "files": [], "axis_offsets": [], "objects": [], "parameters": []})"),
            "header: expected an object, got 1");
  EXPECT_EQ(message_of(R"({"header": 1, "files": [], "axis_offsets": [], "objects": 2})"),
            "catalogue: field \"objects\": expected a list of rows, got 2");
  EXPECT_EQ(message_of(R"({"header": 1, "rows": 2})"),
            "catalogue: unknown field \"rows\": expected one of header, files, axis_offsets, objects, parameters");
}

std::string with_header(const std::string& from, const std::string& to) {
  std::string text = catalogue("");
  return text.replace(text.find(from), from.size(), to);
}

TEST(Catalogue, RefusesAHeaderThatAnEdsCannotCarry) {
  EXPECT_EQ(message_of(with_header("12-31-2026", "2026-12-31")),
            "header: field \"created_date\": expected a date as 12-31-2026, got \"2026-12-31\"");
  EXPECT_EQ(message_of(with_header("10:00AM", "10:00")),
            "header: field \"created_time\": expected a time as 10:00AM, got \"10:00\"");
  EXPECT_EQ(message_of(with_header("\"file_version\": 1", "\"file_version\": 256")),
            "header: field \"file_version\": expected an integer 0 to 255, got 256");
  EXPECT_EQ(message_of(with_header("\"dummies\": []", R"("dummies": ["0005", "0008"])")),
            "header: field \"dummies\": expected data types 0001 to 0007, ascending, got [\"0005\",\"0008\"]");
  EXPECT_EQ(message_of(with_header("\"dummies\": []", R"("dummies": ["0005", "0005"])")),
            "header: field \"dummies\": expected data types 0001 to 0007, ascending, got [\"0005\",\"0005\"]");
  EXPECT_EQ(message_of(with_header("[\"c\"]", "[1]")),
            "header: field \"comments\": expected a list of texts of printable ASCII, got [1]");
}

}  // namespace
}  // namespace eds
