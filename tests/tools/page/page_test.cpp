#include "tools/axisctl/page/page.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fakes/temporary_directory.hpp"
#include "tools/axisctl/page/base64.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/page/resources.hpp"
#include "tools/axisctl/page/unit_recorder.hpp"

using axisctl::ExitStatus;
using axisctl::Expected;
using axisctl::Page;
using axisctl::PageUnit;
using nlohmann::json;

namespace {

constexpr const char* kBlank =
    "<title>x</title><script type=\"application/json\" id=\"session\">null</script><p>null</p>";

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// A unit that keeps in mind what it was asked for.
struct FakeUnit {
  std::vector<std::string> asked{};
  std::string dies_at{};  ///< the method that it no longer answers

  axisctl::Ask ask() {
    return [this](std::string_view method, json params) -> Expected<json> {
      asked.push_back(std::string{method} + params.dump());
      if (method == dies_at) return axisctl::fail(ExitStatus::CutOff, "gone");
      if (method == "status") return json{{"axes", json::array({{{"axis", 1}}, {{"axis", 2}}})}};
      if (params.value("axis", json{}) == "infeed") return axisctl::fail(ExitStatus::NotThere, "no infeed");
      if (method == "object.list") return page_of(params.value("from", 0));
      return json{{"method", method}};
    };
  }
  /// Objects in pages of two.
  static json page_of(int from) {
    json page{{"objects", json::array({from, from + 1})}, {"count", 5}};
    if (from < 4) page["next"] = static_cast<unsigned>(from) + 2U;
    return page;
  }
};

}  // namespace

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(axisctl::base64(""), "");
  EXPECT_EQ(axisctl::base64("f"), "Zg==");
  EXPECT_EQ(axisctl::base64("fo"), "Zm8=");
  EXPECT_EQ(axisctl::base64("foo"), "Zm9v");
  EXPECT_EQ(axisctl::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(axisctl::base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(axisctl::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(axisctl::base64(std::string{"\0\xFF\xFB\xEF", 4}), "AP/77w==");
}

TEST(APage, EndsNoScriptWhateverATextIs) {
  const std::string nasty = "</script><!--<script>\xE2\x80\xA8\"\\";
  const std::string text = axisctl::script_text({{"text", nasty}});
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(json::parse(text).at("text"), nasty);
}

TEST(APage, TakesBytesThatAreNoText) {
  EXPECT_TRUE(json::accept(axisctl::script_text({{"text", "\xFF\xFE"}})));
}

TEST(APage, HasItsSessionInPlaceOfNull) {
  const auto page = axisctl::fill_page(kBlank, Page{.title = "a < b"});
  ASSERT_TRUE(page) << page.error();
  const std::string begin = "<title>x</title><script type=\"application/json\" id=\"session\">";
  const std::string end = "</script><p>null</p>";
  ASSERT_TRUE(page->starts_with(begin) && page->ends_with(end)) << *page;
  const json session = json::parse(page->substr(begin.size(), page->size() - begin.size() - end.size()));
  EXPECT_EQ(session.at("format"), "axisd-session");
  EXPECT_EQ(session.at("version"), 1);
  EXPECT_EQ(session.at("title"), "a < b");
  EXPECT_FALSE(session.contains("verdict"));
}

TEST(APage, NeedsOnePlaceForItsSession) {
  EXPECT_FALSE(axisctl::fill_page("<p>nothing</p>", {}));
  EXPECT_FALSE(axisctl::fill_page(std::string{kBlank} + kBlank, {}));
}

TEST(APage, HasWhatThereIsOfAUnit) {
  PageUnit unit{.unit = "vcan0/5", .resources = {{"", {{"node_id", 5}}}}, .eds = "[FileInfo]\r\n"};
  unit.recordings.push_back({.name = "run.axrec", .content = "AXISREC\n"});
  Page page{.title = "t", .units = {unit, {.unit = "vcan0/6", .name = "other"}}};
  page.verdict = {.passed = false, .text = "report", .report = {{"steps", json::array()}}};
  const json value = axisctl::json_of(page);
  EXPECT_EQ(value.at("units").at(0), (json{{"unit", "vcan0/5"},
                                           {"resources", {{"", {{"node_id", 5}}}}},
                                           {"eds", "[FileInfo]\r\n"},
                                           {"recordings", {{{"name", "run.axrec"}, {"data", "QVhJU1JFQwo="}}}}}));
  EXPECT_EQ(value.at("units").at(1).at("name"), "other");
  EXPECT_FALSE(value.at("units").at(1).contains("eds"));
  EXPECT_EQ(value.at("verdict"), (json{{"passed", false}, {"text", "report"}}));
  EXPECT_TRUE(value.at("report").contains("steps"));
}

TEST(APage, KnowsTheProfileOfAUnitByWhatItTellsElseByItsRecording) {
  PageUnit unit{.unit = "vcan0/5"};
  EXPECT_EQ(axisctl::profile_of(unit), "s120");
  unit.recordings.push_back({.name = "run.axrec", .head = {{"axes", json::array()}}});
  EXPECT_EQ(axisctl::profile_of(unit), "s120");
  unit.recordings.push_back({.name = "late.axrec", .head = {{"profile", "cia402"}}});
  EXPECT_EQ(axisctl::profile_of(unit), "cia402");
  unit.resources = {{"", {{"node_id", 5}}}};
  EXPECT_EQ(axisctl::profile_of(unit), "cia402");
  unit.resources = {{"", {{"profile", "s120"}}}};
  EXPECT_EQ(axisctl::profile_of(unit), "s120");
}

TEST(ASnapshot, HasLongListsInOnePiece) {
  FakeUnit unit;
  const auto snapshot = axisctl::take_snapshot(unit.ask());
  EXPECT_EQ(snapshot.resources.at("objects"), (json{{"objects", {0, 1, 2, 3, 4, 5}}, {"count", 5}}));
  EXPECT_FALSE(snapshot.cut_off);
}

TEST(ASnapshot, HasEachDriveObjectAndLeavesOutWhatIsRefused) {
  FakeUnit unit;
  const json resources = axisctl::take_snapshot(unit.ask()).resources;
  for (const char* const path : {"axes/0/parameters", "axes/1/parameters", "axes/2/parameters", "axes/2/load"})
    EXPECT_TRUE(resources.contains(path)) << path;
  EXPECT_FALSE(resources.contains("axes/0/load"));
  EXPECT_FALSE(resources.contains("axes/infeed/parameters"));
  EXPECT_EQ(std::ranges::count(unit.asked, R"(pdo.list{"all":true})"), 1);
  EXPECT_EQ(std::ranges::count(unit.asked, R"(parameter.diff{"against":"stored"})"), 1);
}

TEST(ASnapshot, EndsWithAUnitThatAnswersNoMore) {
  FakeUnit unit{.dies_at = "supply.get"};
  const auto snapshot = axisctl::take_snapshot(unit.ask());
  ASSERT_TRUE(snapshot.cut_off);
  EXPECT_EQ(unit.asked.back(), "supply.get{}");
  EXPECT_TRUE(snapshot.resources.contains(""));
}

TEST(ASnapshot, HasEachPathOnce) {
  std::vector<std::string_view> paths;
  for (const axisctl::Resource& resource : axisctl::resources()) paths.push_back(resource.path);
  std::ranges::sort(paths);
  EXPECT_EQ(std::ranges::adjacent_find(paths), paths.end());
}

TEST(ARecordingOfAPage, HasFourSignalsOfEachAxisAsFarAsThereIsRoom) {
  EXPECT_EQ(axisctl::default_signals(1),
            (std::vector<std::string>{"1/speed", "1/speed_setpoint", "1/torque", "1/current"}));
  EXPECT_EQ(axisctl::default_signals(8).size(), 16U);
  EXPECT_EQ(axisctl::default_signals(8).back(), "4/current");
}

TEST(AFile, IsWholeOrWhatItWas) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("page.html");
  ASSERT_TRUE(axisctl::write_whole(path, "one"));
  ASSERT_TRUE(axisctl::write_whole(path, "two"));
  EXPECT_EQ(content_of(path), "two");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder.path()}, {}), 1);
}

TEST(AFile, IsWrittenWhereALinkLeads) {
  const fakes::TemporaryDirectory folder;
  ASSERT_TRUE(axisctl::write_whole(folder.path("target"), "one"));
  std::filesystem::create_symlink("target", folder.path("link"));
  ASSERT_TRUE(axisctl::write_whole(folder.path("link"), "two"));
  EXPECT_EQ(content_of(folder.path("target")), "two");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
}

TEST(AFile, IsRefusedWhereNoneCanBe) {
  const fakes::TemporaryDirectory folder;
  const auto into_folder = axisctl::write_whole(folder.path(), "x");
  ASSERT_FALSE(into_folder);
  EXPECT_EQ(into_folder.error().message, folder.path() + ": cannot be written: Is a directory");
  const auto missing = axisctl::write_whole(folder.path("none/page.html"), "x");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().status, ExitStatus::Failed);
  EXPECT_NE(missing.error().message.find("No such file or directory"), std::string::npos);
  EXPECT_FALSE(axisctl::check_folder_of(folder.path("none/page.html")));
  EXPECT_TRUE(axisctl::check_folder_of("page.html"));
}
