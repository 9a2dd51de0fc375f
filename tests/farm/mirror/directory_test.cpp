#include "farm/mirror/directory.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Instant kStart = seconds{100};

DoorBeat beat_of(const std::string& host, const std::vector<std::string>& nodes, std::uint32_t part = 1,
                 std::uint32_t parts = 1) {
  DoorBeat beat{.host = host, .instance = 1, .version = "1", .units = {}, .part = part, .parts = parts};
  for (const std::string& node : nodes) beat.units.push_back({.name = {"line1", node}, .profile = "s120"});
  return beat;
}

std::string text_of(const std::vector<Directory::Entry>& units) {
  std::string text;
  for (const Directory::Entry& entry : units) text += entry.unit.name.node + entry.host + ' ';
  return text;
}

TEST(Directory, KnowsTheUnitsThatDoorsTellOf) {
  Directory directory{seconds{2}};

  EXPECT_TRUE(directory.take(beat_of("b", {"7"}), kStart));
  EXPECT_TRUE(directory.take(beat_of("a", {"6", "5"}), kStart));
  EXPECT_FALSE(directory.take(beat_of("a", {"5", "6"}), kStart));

  EXPECT_EQ(text_of(directory.units(kStart)), "5a 6a 7b ");
  EXPECT_EQ(directory.find({"line1", "7"}, kStart)->host, "b");
  EXPECT_EQ(directory.find({"line1", "8"}, kStart).error().host, "");
}

TEST(Directory, TakesAListInPartsWhenAllHaveCome) {
  Directory directory{seconds{2}};
  directory.take(beat_of("a", {"1"}), kStart);

  EXPECT_FALSE(directory.take(beat_of("a", {"2"}, 1, 2), kStart));
  EXPECT_EQ(text_of(directory.units(kStart)), "1a ");
  EXPECT_TRUE(directory.take(beat_of("a", {"3"}, 2, 2), kStart));
  EXPECT_EQ(text_of(directory.units(kStart)), "2a 3a ");

  // Part 2 was lost, and the next list begins.
  EXPECT_FALSE(directory.take(beat_of("a", {"4"}, 1, 2), kStart));
  EXPECT_FALSE(directory.take(beat_of("a", {"5"}, 1, 2), kStart));
  EXPECT_TRUE(directory.take(beat_of("a", {"6"}, 2, 2), kStart));
  EXPECT_EQ(text_of(directory.units(kStart)), "5a 6a ");
}

TEST(Directory, SaysWhereAUnitWasWhoseHostIsSilent) {
  Directory directory{seconds{2}};
  directory.take(beat_of("a", {"5"}), kStart);
  directory.take(beat_of("b", {"6"}), kStart + seconds{2});

  const Instant late = kStart + milliseconds{2500};
  EXPECT_EQ(text_of(directory.units(late)), "6b ");
  const auto absent = directory.find({"line1", "5"}, late);
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().host, "a");
  EXPECT_EQ(absent.error().silent_for, milliseconds{2500});
  EXPECT_EQ(directory.take_silent(late), std::vector<std::string>{"a"});
  EXPECT_TRUE(directory.take_silent(late).empty());

  EXPECT_TRUE(directory.take(beat_of("a", {"5"}), late));
  EXPECT_TRUE(directory.find({"line1", "5"}, late));
}

TEST(Directory, PutsAUnitThatTwoHostsHaveWhereItCameLast) {
  Directory directory{seconds{2}};
  directory.take(beat_of("b", {"5"}), kStart);
  directory.take(beat_of("a", {"5"}), kStart + milliseconds{10});
  directory.take(beat_of("b", {"5"}), kStart + milliseconds{20});

  EXPECT_EQ(directory.find({"line1", "5"}, kStart + milliseconds{20})->host, "a");
  EXPECT_EQ(text_of(directory.units(kStart + milliseconds{20})), "5a ");
}

}  // namespace
}  // namespace farm
