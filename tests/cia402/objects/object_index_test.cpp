#include "cia402/objects/object_index.hpp"

#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "cia402/objects/object_rows.hpp"
#include "tests/eds/rules/eds_reader.hpp"

namespace cia402::object {
namespace {

/// The constant of an object in the text of a header.
std::string constant_of(unsigned index) {
  char text[16];
  std::snprintf(text, sizeof text, " = 0x%04X;", index);
  return text;
}

std::string read_header(const std::string& path) {
  return eds_test::read_file(std::string{SOURCE_FOLDER} + "/" + path);
}

bool is_further_pdo(unsigned index) {
  return index > kRpdoParameter && index < 0x1C00 && index % 0x200 != 0;
}

TEST(ObjectIndex, NamesEveryObjectOfTheDictionary) {
  const std::string names = read_header("cia402/objects/object_index.hpp");
  const std::string all = names + read_header("libcanopen/base/object_index.hpp");
  std::set<unsigned> indices;
  for (const auto& row : object_rows(1)) indices.insert(row.index);

  for (const unsigned index : indices) {
    if (is_further_pdo(index)) continue;
    const std::string& text = index < kFirstProfileObject ? all : names;
    EXPECT_NE(text.find(constant_of(index)), std::string::npos) << constant_of(index);
  }
}

TEST(ObjectIndex, NamesNoObjectTwiceNorOneThatIsNotThere) {
  const std::string names = read_header("cia402/objects/object_index.hpp");
  std::set<unsigned> indices;
  for (const auto& row : object_rows(1)) indices.insert(row.index);

  std::set<unsigned> named;
  for (std::size_t at = names.find("= 0x"); at != std::string::npos; at = names.find("= 0x", at + 1)) {
    const auto index = static_cast<unsigned>(std::stoul(names.substr(at + 4, 4), nullptr, 16));
    if (index == kFirstProfileObject) continue;
    EXPECT_TRUE(named.insert(index).second) << constant_of(index);
    EXPECT_TRUE(indices.contains(index)) << constant_of(index);
  }
  EXPECT_GT(named.size(), 100U);
}

TEST(ObjectIndex, MovesObjectsToTheirAxisAndBack) {
  EXPECT_EQ(index_on_axis(kControlword, 1), 0x6040);
  EXPECT_EQ(index_on_axis(kControlword, 2), 0x6840);
  EXPECT_EQ(index_on_axis(kSingleDeviceType, 8), 0x9FFF);
  EXPECT_EQ(index_on_axis(kRpdoParameter + kPdosPerAxis - 1, 8), 0x15C7);
  EXPECT_EQ(index_on_axis(kTpdoMapping, 3), 0x1A80);
  EXPECT_EQ(index_on_axis(kIdentity, 8), kIdentity) << "the device has it once";
  EXPECT_EQ(index_on_axis(kSdoServer, 2), kSdoServer);

  for (std::size_t axis = 1; axis <= generated::kMostAxes; ++axis) {
    EXPECT_EQ(axis_of(index_on_axis(kAbortConnectionOption, axis)), axis);
    EXPECT_EQ(axis_of(index_on_axis(kSingleDeviceType, axis)), axis);
    EXPECT_EQ(index_on_first_axis(index_on_axis(kTargetVelocity, axis)), kTargetVelocity);
  }
}

}  // namespace
}  // namespace cia402::object
