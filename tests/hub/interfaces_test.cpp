#include "hub/interfaces.hpp"

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

TEST(Interfaces, TakesABoundedNumberOfNames) {
  Interfaces interfaces;
  for (std::size_t i = 0; i < Interfaces::kMost; ++i) ASSERT_NE(interfaces.index_of("can" + std::to_string(i)), 0);

  EXPECT_EQ(interfaces.index_of("vcan0"), 0);
  EXPECT_EQ(interfaces.index_of("can0"), 1001);
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
