#include "farm/storage/object_meta.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace farm {
namespace {

ObjectMeta example() {
  return {"axisd_plant_state", "line1.5/parameters.bin", "NUID", 300'000, 3, "SHA-256=x", false};
}

TEST(ObjectMeta, IsReadAsItIsWritten) {
  const auto read = parse_object_meta(text_of(example()));

  ASSERT_TRUE(read);
  EXPECT_EQ(read->bucket, example().bucket);
  EXPECT_EQ(read->name, example().name);
  EXPECT_EQ(read->nuid, example().nuid);
  EXPECT_EQ(read->size, example().size);
  EXPECT_EQ(read->chunks, example().chunks);
  EXPECT_EQ(read->digest, example().digest);
  EXPECT_FALSE(read->is_deleted);
}

TEST(ObjectMeta, HasTheMembersThatOtherClientsRead) {
  const auto object = nlohmann::json::parse(text_of(example()));

  EXPECT_EQ(object["options"]["max_chunk_size"], 131'072);
  EXPECT_EQ(object["mtime"].get<std::string>().size(), sizeof "2000-01-01T00:00:00Z" - 1);
  EXPECT_FALSE(object.contains("deleted"));
}

TEST(ObjectMeta, ThatIsNoneIsNotRead) {
  for (const char* const text : {"", "[]", "{", R"({"size": "much"})", R"({"size": -1.5e300, "name": 3})"})
    EXPECT_FALSE(parse_object_meta(text)) << text;
}

TEST(ObjectMeta, LiesUnderTheEncodedName) {
  EXPECT_EQ(meta_subject("b", "line1.5/parameters.bin"), "$O.b.M.bGluZTEuNS9wYXJhbWV0ZXJzLmJpbg==");
  EXPECT_EQ(chunk_subject("b", "NUID"), "$O.b.C.NUID");
}

}  // namespace
}  // namespace farm
