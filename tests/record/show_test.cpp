#include "record/show.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "record/segments.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/record/recorded.hpp"

namespace record {
namespace {

using namespace std::chrono_literals;
using Lines = std::vector<std::string>;

class AFile : public testing::Test {
 protected:
  AFile() {
    EXPECT_EQ(files.open(), 0);
    const std::array values{1500.5};
    for (const RecordBytes& record :
         {frame_record({.id = 0x605, .length = 2, .data = {0x40, 1}}, false, 1500ms),
          event_record({.kind = EventKind::Fault, .object = 2, .axis = 1, .number = 7900, .text = "Motor blocked"},
                       2s),
          samples_record(values, 3s)})
      EXPECT_EQ(files.write(record.bytes()), 0);
    EXPECT_EQ(files.close(EndReason::Stopped, 4s), 0);
  }
  Lines shown(Form form) {
    Lines lines;
    remark = show(files.where(), form, [&lines](std::string_view line) { lines.emplace_back(line); });
    return lines;
  }

  fakes::TemporaryDirectory folder;
  Segments files{plan_in(folder.path("recordings"))};
  tl::expected<std::string, std::string> remark;
};

TEST_F(AFile, IsShownAsText) {
  EXPECT_EQ(shown(Form::Text),
            (Lines{"      1.500000 frame    received 605 4001",
                   "      2.000000 event    fault active=true axis=1 drive_object=2 name=F07900 number=7900 "
                   "text=Motor blocked value=0",
                   "      3.000000 samples  1/r0063=1500.5", "      4.000000 end      reason=stopped"}));
  EXPECT_EQ(remark.value(), "");
}

TEST_F(AFile, IsShownAsJson) {
  const Lines lines = shown(Form::Json);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(nlohmann::json::parse(lines[0]).at("head").at("node_id"), 5);
  EXPECT_EQ(
      nlohmann::json::parse(lines[1]),
      (nlohmann::json{{"type", "frame"}, {"t", 1.5}, {"direction", "received"}, {"id", "605"}, {"data", "4001"}}));
  EXPECT_EQ(nlohmann::json::parse(lines[3]).at("values").at("1/r0063"), 1500.5);
}

TEST_F(AFile, IsShownAsCandumpHasIt) {
  EXPECT_EQ(shown(Form::Candump), Lines{"(1700000001.500000) vcan0 605#4001"});
}

TEST_F(AFile, ThatIsCutSaysWhere) {
  std::filesystem::resize_file(files.where(), std::filesystem::file_size(files.where()) - 3);
  EXPECT_EQ(shown(Form::Text).size(), 3U);
  EXPECT_NE(remark.value().find(": cut within a record at byte "), std::string::npos) << remark.value();
}

TEST_F(AFile, ThatIsNoneIsRefusedInOneLine) {
  std::ofstream{files.where(), std::ios::trunc} << "something else";
  EXPECT_TRUE(shown(Form::Text).empty());
  EXPECT_EQ(remark.error(), files.where() + ": no recording: it does not begin with AXISREC");
}

TEST(Show, OfNoFileIsRefusedInOneLine) {
  const auto remark = show("/nowhere.axrec", Form::Text, [](std::string_view) {});
  EXPECT_EQ(remark.error(), "/nowhere.axrec: No such file or directory");
}

}  // namespace
}  // namespace record
