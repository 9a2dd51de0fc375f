#include "can/hub/medium/interfaces.hpp"

#include <string>

#include <gtest/gtest.h>

namespace hub {
namespace {

TEST(Interfaces, GivesEachNameAnIndexAtItsFirstMention) {
  Interfaces interfaces;

  EXPECT_EQ(interfaces.index_of("can0"), 1001);
  EXPECT_EQ(interfaces.index_of("vcan7"), 1002);
  EXPECT_EQ(interfaces.index_of("can0"), 1001);
  EXPECT_EQ(interfaces.name_of(1002), "vcan7");
}

TEST(Interfaces, KnowsNoOtherIndexes) {
  Interfaces interfaces;
  interfaces.index_of("can0");

  for (const int index : {-1, 0, 1, 1000, 1002}) EXPECT_EQ(interfaces.name_of(index), "") << index;
}

TEST(Interfaces, TakesOnlyNamesOfCanInterfaces) {
  Interfaces interfaces;

  for (const char* const name : {"can0", "vcan12", "slcan0", "canary1", "cancan3", "abcdefghican123"})
    EXPECT_NE(interfaces.index_of(name), 0) << name;
  for (const char* const name :
       {"", "eth0", "can", "0", "can0a", "Can0", "can-0", "cn0", "can0 ", "lo", "abcdefghijcan123", "c0an1"})
    EXPECT_EQ(interfaces.index_of(name), 0) << name;
}

/// As many names as there may be, each of them held.
Interfaces full_of_members() {
  Interfaces interfaces;
  for (std::size_t i = 0; i < Interfaces::kMost; ++i)
    interfaces.hold(interfaces.index_of("can" + std::to_string(i)));
  return interfaces;
}

TEST(Interfaces, TakesABoundedNumberOfNames) {
  Interfaces interfaces = full_of_members();

  EXPECT_EQ(interfaces.entries().size(), Interfaces::kMost);
  EXPECT_EQ(interfaces.index_of("vcan0"), 0);
  EXPECT_EQ(interfaces.index_of("can0"), 1001);
}

TEST(Interfaces, GivesThePlaceOfANameThatNobodyIsBoundToAnother) {
  Interfaces interfaces = full_of_members();
  interfaces.release(interfaces.index_of("can7"));

  const int index = interfaces.index_of("vcan0");

  EXPECT_EQ(interfaces.name_of(index), "vcan0");
  EXPECT_EQ(interfaces.name_of(1008), "") << "its index is used no more";
  EXPECT_EQ(interfaces.index_of("can7"), index + static_cast<int>(Interfaces::kMost))
      << "nobody is bound to vcan0";
  EXPECT_EQ(interfaces.entries().size(), Interfaces::kMost);
}

TEST(Interfaces, KeepsANameAsLongAsAnyoneIsBoundToIt) {
  Interfaces interfaces = full_of_members();
  interfaces.hold(1008);
  interfaces.release(1008);

  EXPECT_EQ(interfaces.index_of("vcan0"), 0);
  interfaces.release(1008);
  EXPECT_NE(interfaces.index_of("vcan0"), 0);
}

TEST(Interfaces, GivesUpTheNameThatWasNotMentionedLongest) {
  Interfaces interfaces;
  for (std::size_t i = 0; i < Interfaces::kMost; ++i) interfaces.index_of("can" + std::to_string(i));
  interfaces.index_of("can0");

  for (int i = 0; i < 1000; ++i) {
    interfaces.index_of("can0");
    ASSERT_NE(interfaces.index_of("vcan" + std::to_string(i)), 0) << i;
  }

  EXPECT_EQ(interfaces.index_of("can0"), 1001);
  EXPECT_EQ(interfaces.name_of(1002), "");
}

TEST(Interfaces, HasANameForFramesThatComeWithoutOne) {
  Interfaces unnamed;
  Interfaces named;
  named.index_of("vcan3");

  EXPECT_EQ(unnamed.name_of(unnamed.common_index()), "can0");
  EXPECT_EQ(named.name_of(named.common_index()), "vcan3");
}

}  // namespace
}  // namespace hub
