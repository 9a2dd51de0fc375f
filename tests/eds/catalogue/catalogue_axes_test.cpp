#include <array>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "eds/catalogue/axes.hpp"
#include "eds/writer/eds_writer.hpp"
#include "tests/eds/catalogue/catalogue_text.hpp"

/// What the catalogue says of several axes, of parameters and of the files.
namespace eds {
namespace {

using std::string_literals::operator""s;

const std::string kMapped =
    variable(R"(, "pdo": true, "default": "1", "other_axes": "2", "vector": "3")", "UNSIGNED8", "rww");
const std::string kMapping = rows({head("1600", "RECORD"), sub("1600", "00", "UNSIGNED8", "1", "rw"),
                                   sub("1600", "01", "UNSIGNED32", "0x60000008", "rw"),
                                   sub("1600", "02", "UNSIGNED32", "0", "rw"), kMapped});

TEST(CatalogueAxes, MoveByTheOffsetOfTheirRange) {
  const Catalogue read = parse_catalogue(catalogue(kMapping));

  const auto third = axis_objects(read, 3, DriveType::Servo);

  EXPECT_NE(find_entry(third, 0x1680, 0), nullptr);
  EXPECT_NE(find_entry(third, 0x7200, 0), nullptr);
  EXPECT_EQ(find_entry(third, 0x6000, 0), nullptr);
}

TEST(CatalogueAxes, MapTheirOwnObjects) {
  const Catalogue read = parse_catalogue(catalogue(kMapping));

  const auto second = axis_objects(read, 2, DriveType::Servo);

  EXPECT_EQ(find_entry(second, 0x1640, 1)->initial.text, "0x69000008");
  EXPECT_EQ(find_entry(second, 0x1640, 2)->initial.value, 0) << "an empty entry stays empty";
}

TEST(CatalogueAxes, StartWithTheValuesOfTheirPlaceAndType) {
  const Catalogue read = parse_catalogue(catalogue(kMapping));

  EXPECT_EQ(find_entry(axis_objects(read, 1, DriveType::Servo), 0x6000, 0)->initial.value, 1);
  EXPECT_EQ(find_entry(axis_objects(read, 2, DriveType::Servo), 0x6900, 0)->initial.value, 2);
  EXPECT_EQ(find_entry(axis_objects(read, 1, DriveType::Vector), 0x6000, 0)->initial.value, 3);
}

TEST(CatalogueAxes, ChangeWhatTheUnitHasOnceWhereThereAreSeveral) {
  const Catalogue read = parse_catalogue(catalogue(
      R"({"index": "1019", "sub": "00", "object": "VAR", "type": "UNSIGNED8", "access": "ro", "pdo": false,
                    "default": "1", "several_axes": "2", "scope": "unit", "name": "N", "does": "d"})"));

  const auto value_of = [&](std::size_t axes) {
    return find_entry(unit_objects(read, std::vector<DriveType>(axes, DriveType::Servo)), 0x1019, 0)
        ->initial.value;
  };
  EXPECT_EQ(value_of(1), 1);
  EXPECT_EQ(value_of(2), 2);
  EXPECT_EQ(value_of(8), 2);
}

TEST(CatalogueAxes, StandBetweenTheObjectsOfTheUnitByIndex) {
  const Catalogue read = parse_catalogue(catalogue(kMapping));

  const auto unit = unit_objects(read, std::array{DriveType::Servo, DriveType::Servo});

  std::vector<unsigned> indices;
  for (const Object& object : unit) indices.push_back(object.index);
  EXPECT_EQ(indices, (std::vector<unsigned>{0x1000, 0x1001, 0x1018, 0x1600, 0x1640, 0x6000, 0x6900}));
}

std::string parameter(const std::string& scope, const std::string& sub_index, const std::string& more,
                      const std::string& index = "2025") {
  return R"({"index": ")" + index + R"(", "sub": ")" + sub_index +
         R"(", "object": "VAR", "type": "REAL32", "access": "rw", "pdo": false, "scope": ")" + scope +
         R"(", "name": "N")" + more + "}";
}
std::string parameter_head(const std::string& scope, const std::string& code) {
  return R"({"index": "2025", "object": ")" + code + R"(", "scope": ")" + scope + R"(", "name": "N"})";
}

TEST(CatalogueParameters, BelongToTheDriveObjectsOfTheirScope) {
  const Catalogue read = parse_catalogue(
      catalogue("", rows({parameter("cu-parameter", "00", ""), parameter_head("axis-parameter", "ARRAY"),
                          parameter("axis-parameter", "00-01", ""), parameter("parameter", "00", "", "2026"),
                          parameter("vector-parameter", "00", "", "2027")})));

  EXPECT_EQ(parameter_objects(read, FileContent::ControlUnit).size(), 2U);
  EXPECT_EQ(parameter_objects(read, FileContent::Servo).size(), 2U);
  EXPECT_EQ(parameter_objects(read, FileContent::Vector).size(), 3U);
  EXPECT_EQ(parameter_objects(read, FileContent::Axes).size(), 0U);
}

TEST(CatalogueParameters, KeepTheirDecimalsInTheEds) {
  const std::string list = R"({"name": "a.eds", "content": "servo", "description": "d"})";
  const Catalogue read = parse_catalogue(
      whole(list, kOffsets, kMandatory,
            parameter("parameter", "00", R"(, "default": "1.00", "low": "-0.50", "high": "650.00")")));

  const std::string text = write_eds(read, read.files.front());

  EXPECT_NE(text.find("LowLimit=-0.50\nHighLimit=650.00\nAccessType=rw\nDefaultValue=1.00\n"), std::string::npos);
}

/// A broken catalogue and the whole message it must give.
struct Case {
  const char* name;
  std::string text;
  std::string message;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class BrokenCatalogue : public testing::TestWithParam<Case> {};

TEST_P(BrokenCatalogue, IsRefusedWithPlaceFieldAndExpectation) {
  EXPECT_EQ(message_of(GetParam().text), GetParam().message);
}

std::string with_parameters(const std::string& parameters) {
  return catalogue("", parameters);
}
std::string with_files(const std::string& files) {
  return whole(files, kOffsets, kMandatory, "");
}
std::string with_offsets(const std::string& offsets) {
  return whole(kFiles, offsets, kMandatory, "");
}

const std::string kPlace = "parameter row 1 (2025:00): ";
const std::string kPlain = R"(, "pdo": false, "default": "0")";

const std::string kShortList =
    R"({"index": "1027", "object": "ARRAY", "scope": "unit", "name": "N", "does": "d"},
       {"index": "1027", "sub": "00", "object": "VAR", "type": "UNSIGNED8", "access": "ro", "pdo": false,
        "value": "1", "scope": "unit", "name": "N"},
       {"index": "1027", "sub": "01", "object": "VAR", "type": "UNSIGNED16", "access": "ro", "pdo": false,
        "default": "0x000B", "scope": "unit", "name": "N"})";

const Case kBroken[] = {
    {"ParameterAmongTheObjects",
     catalogue(R"({"index": "2025", "object": "ARRAY", "scope": "parameter", "name": "N"})"),
     "row 6 (2025): field \"scope\": expected one of unit, axis, got \"parameter\""},
    {"ObjectAmongTheParameters", with_parameters(parameter("unit", "00", "")),
     kPlace + "field \"scope\": expected one of parameter, cu-parameter, axis-parameter, servo-parameter, "
              "vector-parameter, got \"unit\""},
    {"ValueOfAParameter", with_parameters(parameter("parameter", "00", R"(, "value": "1.0")")),
     kPlace + "field \"value\": expected \"default\" or nothing for a parameter, got \"1.0\""},
    {"RealThatIsNone", with_parameters(parameter("parameter", "00", R"(, "default": "0x10")")),
     kPlace + "field \"default\": expected a decimal number as text, got \"0x10\""},
    {"RealAboveItsLimit", with_parameters(parameter("parameter", "00", R"(, "default": "1.5", "high": "1.25")")),
     kPlace + "field \"default\": expected at most \"high\", got \"1.5\""},
    {"ParameterTwice", with_parameters(rows({parameter("parameter", "00", ""), parameter("parameter", "00", "")})),
     "parameter row 2 (2025:00): field \"sub\": expected 2025:00 in one row only"},
    {"ParameterOfTwoScopes",
     with_parameters(rows({parameter("parameter", "00", ""), parameter("cu-parameter", "00", "")})),
     "2025:00: expected one object of this index in the drive object control-unit"},
    {"ParameterOutsideTheWindow", with_parameters(parameter("parameter", "00", "", "4710")),
     "4710:00: expected a parameter object, 2000h to 470Fh"},
    {"ParameterRecord",
     with_parameters(rows({parameter_head("parameter", "RECORD"), parameter("parameter", "00", "")})),
     "2025:00: expected VAR or ARRAY for a parameter"},
    {"ParameterWithoutValue", with_parameters(parameter_head("parameter", "ARRAY")),
     "2025:00: expected a row, the parameter has no value"},
    {"ParameterWithAGap",
     with_parameters(rows({parameter_head("parameter", "ARRAY"), parameter("parameter", "01", "")})),
     "2025:00: expected a row, the array has a gap"},
    {"ParameterWithoutArray", with_parameters(parameter("parameter", "00-01", "")),
     "2025:01: expected one row with sub 00 for a VAR, or an ARRAY row first"},
    {"OtherAxesOfTheUnit",
     catalogue(rows({R"({"index": "1019", "sub": "00", "object": "VAR", "type": "UNSIGNED8", "access": "ro", )"s +
                     R"("scope": "unit", "name": "N", "does": "d", "other_axes": "1")" + kPlain + "}"})),
     "row 6 (1019:00): field \"other_axes\": expected it in the scope axis only, got \"1\""},
    {"SeveralAxesOfAnAxis", catalogue(variable(kPlain + R"(, "several_axes": "1")")),
     "row 6 (6000:00): field \"several_axes\": expected it in the scope unit only, got \"1\""},
    {"OtherAxesAboveTheLimit", catalogue(variable(kPlain + R"(, "high": "5", "other_axes": "6")")),
     "row 6 (6000:00): field \"other_axes\": expected at most \"high\", got \"6\""},
    {"VectorNotRepresentable", catalogue(variable(kPlain + R"(, "vector": "256")")),
     "row 6 (6000:00): field \"vector\": expected a number as text, 0 to 255, got \"256\""},
    {"DoesTwice",
     catalogue(rows({head("6000", "RECORD"), sub("6000", "00", "UNSIGNED8", "0").insert(1, R"("does": "d", )")})),
     "row 7 (6000:00): field \"does\": expected it in the object's first row only"},
    {"DoesMissing", catalogue(sub("6000", "00", "UNSIGNED8", "0")),
     "6000:00: expected \"does\" in the row that opens the object"},
    {"AxisWithoutOffset", whole(kFiles, "", kMandatory + "," + variable(kPlain), ""),
     "6000:00: expected an axis offset for an object of an axis"},
    {"AxesThatMeet",
     whole(
         kFiles,
         R"({"first": "5F00", "last": "5F7F", "offset": "0080"}, {"first": "5F80", "last": "5FFF", "offset": "0080"})",
         kMandatory + "," + sub("5F00", "00", "UNSIGNED8", "0") + "," + sub("5F80", "00", "UNSIGNED8", "0"), ""),
     "5F80:00: expected one object of this index in a unit of 8 axes"},
    {"ModuleListTooShort", catalogue(kShortList), "1027:00: expected 8 modules"},
    {"FileName", with_files(R"({"name": "a.txt", "content": "servo", "description": "d"})"),
     "file 1: field \"name\": expected a file name that ends with .eds, got \"a.txt\""},
    {"FileTwice", with_files(kFiles + "," + kFiles),
     "file 2: field \"name\": expected every name once, got \"a.eds\""},
    {"FileContent", with_files(R"({"name": "a.eds", "content": "unit", "description": "d"})"),
     "file 1: field \"content\": expected one of axes, modules, control-unit, servo, vector, got \"unit\""},
    {"FileOfNineAxes", with_files(R"({"name": "a.eds", "content": "axes", "axes": 9, "description": "d"})"),
     "file 1: field \"axes\": expected an integer 0 to 8, got 9"},
    {"FileOfNoAxes", with_files(R"({"name": "a.eds", "content": "axes", "axes": 0, "description": "d"})"),
     "file 1: field \"axes\": expected 1 to 8 for the content axes, nothing for the others, got 0"},
    {"FileOfAServoWithAxes", with_files(R"({"name": "a.eds", "content": "servo", "axes": 1, "description": "d"})"),
     "file 1: field \"axes\": expected 1 to 8 for the content axes, nothing for the others, got 1"},
    {"OffsetForm", with_offsets(R"({"first": "16", "last": "163F", "offset": "0040"})"),
     "axis offset 1: field \"first\": expected four hexadecimal digits, got \"16\""},
    {"OffsetBackwards", with_offsets(R"({"first": "1640", "last": "163F", "offset": "0040"})"),
     "axis offset 1: field \"last\": expected at least \"first\", got \"163F\""},
    {"OffsetTooSmall", with_offsets(R"({"first": "1600", "last": "1640", "offset": "0040"})"),
     "axis offset 1: field \"offset\": expected more than the range is long, got \"0040\""},
    {"OffsetTooLarge", with_offsets(R"({"first": "6000", "last": "67FF", "offset": "2000"})"),
     "axis offset 1: field \"offset\": expected room below FFFF for every axis, got \"2000\""},
    {"OffsetOrder", with_offsets(R"({"first": "6000", "last": "67FF", "offset": "0800"},
                                    {"first": "1600", "last": "163F", "offset": "0040"})"),
     "axis offset 2: field \"first\": expected ranges in ascending order, got \"1600\""},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, BrokenCatalogue, testing::ValuesIn(kBroken),
                         [](const auto& broken) { return std::string{broken.param.name}; });

}  // namespace
}  // namespace eds
