// Streams of bytes that reach something each, as tests/fuzz/modbus has found them.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "tests/modbus/stream_properties.hpp"

namespace modbus {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(KeptStreams, AreHandledByTheRules) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator{MODBUS_STREAMS}) {
    std::ifstream file{entry.path(), std::ios::binary};
    const Bytes input{std::istreambuf_iterator<char>{file}, {}};
    EXPECT_EQ(broken_rule(input), "") << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(RandomStreams, AreHandledByTheRules) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  for (int round = 0; round < 300; ++round) {
    Bytes input(random() % 600);
    for (std::uint8_t& byte : input)
      byte = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 20);
    ASSERT_EQ(broken_rule(input), "");
  }
}

}  // namespace
}  // namespace modbus
