#include "farm/agent/unit/unit_folder.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace farm::agent {
namespace {

using nlohmann::json;

const UnitName kUnit{"line1", "5"};

class UnitFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "axisd-agent-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folders = {name + "/run", name + "/state"};
    root = name;
  }
  void TearDown() override { std::filesystem::remove_all(root); }

  static std::string content_of(const std::string& path) {
    std::ifstream file{path};
    return {std::istreambuf_iterator<char>{file}, {}};
  }
  json file_of(const UnitName& unit, const std::string& configuration) const {
    return json::parse(configuration_file(folders, unit, configuration).value());
  }

  std::string root;
  Folders folders;
};

TEST_F(UnitFolderTest, HasTheNamesThatAxisdHas) {
  const Folders at{"/run/agent", "/var/agent"};

  EXPECT_EQ(at.socket(kUnit), "/run/agent/axisd-line1-5.sock");
  EXPECT_EQ(at.hub("line1"), "/run/agent/line1/can-bus");
  EXPECT_EQ(at.configuration(kUnit), "/run/agent/line1/5.json");
  EXPECT_EQ(at.parameters(kUnit), "/var/agent/line1-5/parameters.bin");
  EXPECT_EQ(at.note(kUnit), "/var/agent/line1-5/agent.json");
}

TEST_F(UnitFolderTest, ReplacesAFileInAFolderThatItMakes) {
  const std::string path = folders.parameters(kUnit);

  EXPECT_EQ(checksum_of_parameters(folders, kUnit).value(), std::nullopt);
  ASSERT_TRUE(replace_file(path, "first"));
  ASSERT_TRUE(replace_file(path, "123456789"));
  EXPECT_EQ(content_of(path), "123456789");
  EXPECT_EQ(checksum_of_parameters(folders, kUnit).value(), 0xCBF43926U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folders.state + "/line1-5"}, {}), 1);
}

TEST_F(UnitFolderTest, TellsWhatCannotBeReadFromWhatIsNotThere) {
  EXPECT_EQ(read_parameters(folders, kUnit).value(), std::nullopt);
  EXPECT_EQ(read_note(folders, kUnit).value(), UnitNote{});

  std::filesystem::create_directories(folders.parameters(kUnit));
  std::filesystem::create_directories(folders.note(kUnit));
  EXPECT_EQ(read_parameters(folders, kUnit).error(),
            folders.parameters(kUnit) + ": cannot be read: Is a directory");
  EXPECT_EQ(checksum_of_parameters(folders, kUnit).error(),
            folders.parameters(kUnit) + ": cannot be read: Is a directory");
  EXPECT_EQ(read_note(folders, kUnit).error(), folders.note(kUnit) + ": cannot be read: Is a directory");
}

TEST_F(UnitFolderTest, SaysWhatCannotBeWritten) {
  std::ofstream{root + "/state"} << "in the way";

  const auto written = replace_file(folders.parameters(kUnit), "x");

  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().find(folders.parameters(kUnit) + ": cannot be written: "), 0u);
}

TEST_F(UnitFolderTest, AddsToAConfigurationWhatTheNameSays) {
  const json file = file_of(kUnit, R"({"axes":[{}]})");

  EXPECT_EQ(file, (json{{"axes", json::array({json::object()})},
                        {"bus", "line1"},
                        {"interface", "unix:" + folders.hub("line1")},
                        {"node_id", 5}}));
}

TEST_F(UnitFolderTest, HasAUnitWithoutNodeIdByItsSerialNumber) {
  EXPECT_EQ(file_of({"line1", "unconfigured"}, "{}").at("node_id"), 255);
  EXPECT_EQ(file_of({"line1", "unconfigured-7"}, "{}").at("serial"), 7);
  EXPECT_EQ(file_of({"line1", "unconfigured-7"}, R"({"serial":7})").at("serial"), 7);
  EXPECT_EQ(configuration_file(folders, {"line1", "unconfigured-7"}, R"({"serial":8})").error(),
            "configuration/serial: expected 7, as the key says, got 8");
}

TEST(UnitNote, IsReadAsItIsWritten) {
  UnitNote note{.kept = {7, "g"}, .configuration = R"({"axes":[{}]})", .uploaded = 0xCBF43926};
  EXPECT_EQ(parse_unit_note(text_of(note)), note);

  note.uploaded.reset();
  EXPECT_EQ(parse_unit_note(text_of(note)), note);
}

TEST(UnitNote, ThatIsNoneIsNothing) {
  for (const char* const text : {"", "[]", "{}", R"({"term":-1,"generation":"","configuration":""})"})
    EXPECT_EQ(parse_unit_note(text), std::nullopt) << text;
}

TEST(KeptState, IsTheNewestWhileNobodyElseHasRunTheUnit) {
  const UnitStart start{.unit = kUnit, .configuration = "{}", .term = 8, .generation = "g"};

  EXPECT_TRUE((KeptState{7, "g"}.is_newest_for(start)));
  EXPECT_TRUE((KeptState{8, "g"}.is_newest_for(start)));
  EXPECT_FALSE((KeptState{6, "g"}.is_newest_for(start)));
  EXPECT_FALSE((KeptState{7, "other"}.is_newest_for(start)));
  EXPECT_FALSE((KeptState{}.is_newest_for(start)));
}

}  // namespace
}  // namespace farm::agent
