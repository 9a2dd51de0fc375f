#include "record/segments.hpp"

#include <gtest/gtest.h>

#include "tests/fakes/temporary_directory.hpp"
#include "tests/record/recorded.hpp"

namespace record {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  fs::path at(const std::string& name) const { return fs::path{plan.folder} / name; }
  /// A file with one frame under @p identifier.
  void record_one(Segments& files, std::uint32_t identifier) {
    ASSERT_EQ(files.open(), 0);
    ASSERT_EQ(files.write(frame_record({.id = identifier}, true, 1ms).bytes()), 0);
    ASSERT_EQ(files.close(EndReason::Stopped, 2ms), 0);
  }

  fakes::TemporaryDirectory folder;
  Segments::Plan plan = plan_in(folder.path("recordings"));
};

TEST_F(Files, AreARecordingAndTheLogOfCandump) {
  Segments files{plan};
  record_one(files, 0x705);

  EXPECT_EQ(content_of_file(at("run.log")), "(1700000000.001000) vcan0 705#\n");
  EXPECT_EQ(read_all(content_of_file(at("run.axrec"))).records.size(), 2U);
  EXPECT_EQ(fs::status(at("run.axrec")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, OfAFormerRecordingAreKeptAsTheOlderHalf) {
  Segments files{plan};
  for (std::uint32_t identifier : {1U, 2U, 3U}) record_one(files, identifier);

  EXPECT_EQ(content_of_file(at("run.log")), "(1700000000.001000) vcan0 003#\n");
  EXPECT_EQ(content_of_file(at("run.1.log")), "(1700000000.001000) vcan0 002#\n");
  EXPECT_TRUE(fs::exists(at("run.1.axrec")));
}

TEST_F(Files, OfFaultsAreTenOfWhichTheOldestMakesRoom) {
  plan.by_faults = true;
  Segments files{plan};
  for (std::uint32_t identifier = 1; identifier <= 12; ++identifier) {
    record_one(files, identifier);
    for (unsigned k = 1; k <= 10; ++k)  // file systems stamp coarsely: the order is made plain
      if (fs::exists(at("run-" + std::to_string(k) + ".axrec")) &&
          at("run-" + std::to_string(k) + ".axrec") == files.where())
        fs::last_write_time(files.where(), fs::file_time_type{std::chrono::seconds{identifier}});
  }

  EXPECT_EQ(content_of_file(at("run-1.log")), "(1700000000.001000) vcan0 00B#\n");
  EXPECT_EQ(content_of_file(at("run-2.log")), "(1700000000.001000) vcan0 00C#\n");
  EXPECT_EQ(content_of_file(at("run-3.log")), "(1700000000.001000) vcan0 003#\n");
  EXPECT_FALSE(fs::exists(at("run-11.axrec")));
}

TEST_F(Files, DoNotFollowWhatHasBeenLaidInTheirPlace) {
  fs::create_directories(plan.folder);
  fs::create_symlink(folder.path("elsewhere"), at("run.log"));
  Segments files{plan};
  record_one(files, 1);
  EXPECT_FALSE(fs::exists(folder.path("elsewhere")));
}

TEST(NameOfARecording, LeadsNowhereElse) {
  for (const char* const good : {"a", "run-3", "2026-11-23_a.b"}) EXPECT_TRUE(is_name(good)) << good;
  for (const std::string& bad :
       {std::string{}, std::string{".."}, std::string{".a"}, std::string{"a/b"}, std::string{"a b"},
        std::string{"\xC3\xA4"}, std::string(65, 'a'), std::string{"a\0b", 3}})
    EXPECT_FALSE(is_name(bad)) << bad;
}

}  // namespace
}  // namespace record
