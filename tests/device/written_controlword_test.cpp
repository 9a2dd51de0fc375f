#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint16_t kState = 0x6F;

TEST(WrittenControlword, EachOfSeveralInOneCycleTakesEffect) {
  TestUnit unit;
  unit.start();

  for (const std::uint32_t word : {0x06U, 0x07U, 0x0FU}) ASSERT_EQ(unit.download(0x6040, 0, word, 2), 0U);

  unit.passes(4 * Device::kCycle);
  EXPECT_EQ(unit.statusword(), 0x1637);
}

TEST(WrittenControlword, ShowsItsAcknowledgementEdgeThoughTheNextFollowsAtOnce) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(100ms);

  for (const std::uint32_t word : {0x80U, 0x00U}) ASSERT_EQ(unit.download(0x6040, 0, word, 2), 0U);

  unit.passes(4 * Device::kCycle);
  EXPECT_EQ(unit.statusword(), 0x1640);
}

TEST(WrittenControlword, GivesWayToProcessData) {
  TestUnit unit;
  unit.start_operational();
  for (const std::uint32_t word : {0x06U, 0x07U, 0x0FU}) ASSERT_EQ(unit.download(0x6040, 0, word, 2), 0U);

  unit.says("205#0600");

  unit.passes(4 * Device::kCycle);
  EXPECT_EQ(unit.statusword() & kState, 0x21);
}

TEST(WrittenControlword, OutlivesAnRpdoThatCarriesNone) {
  TestUnit unit;
  unit.start();
  for (const char* const request : {"605#2301140105030080", "605#2F01160000000000", "605#230116012000FF60",
                                    "605#2F01160001000000", "605#2301140105030000"}) {
    ASSERT_EQ(unit.says(request).front().substr(0, 6), "585#60") << request;
  }
  unit.says("000#0105");
  for (const std::uint32_t word : {0x06U, 0x07U, 0x0FU}) ASSERT_EQ(unit.download(0x6040, 0, word, 2), 0U);

  unit.says("305#00000000");

  unit.passes(4 * Device::kCycle);
  EXPECT_EQ(unit.statusword() & kState, 0x27);
}

TEST(WrittenControlword, DoesNotOutliveAReset) {
  for (const char* const reset : {"000#8105", "000#8205"}) {
    TestUnit unit;
    unit.start();
    unit.says("605#2B40600006000000");
    unit.passes(4 * Device::kCycle);
    for (const std::uint32_t word : {0x06U, 0x07U, 0x00U}) ASSERT_EQ(unit.download(0x6040, 0, word, 2), 0U);

    unit.says(reset);

    for (int cycle = 0; cycle < 8; ++cycle) {
      unit.passes(Device::kCycle);
      EXPECT_EQ(unit.statusword() & kState, 0x40) << reset << " cycle " << cycle;
    }
  }
}

TEST(WrittenControlword, IsForgottenBeyondTheLastThatFits) {
  TestUnit unit;
  unit.start();

  for (int i = 0; i < 100; ++i) ASSERT_EQ(unit.download(0x6040, 0, 0x06, 2), 0U);
  ASSERT_EQ(unit.download(0x6040, 0, 0x07, 2), 0U);

  unit.passes(40 * Device::kCycle);
  EXPECT_EQ(unit.statusword() & kState, 0x23);
}

TEST(WrittenParameter, ActsOnAUnitThatRests) {
  TestUnit unit;
  unit.start_operational();
  ASSERT_EQ(unit.download(0x605D, 0, 0, 2), 0U);
  for (const char* const word : {"205#0600", "205#0700", "205#0F01"}) unit.cycles_with(word);
  unit.passes(1s);
  ASSERT_EQ(unit.statusword() & kState, 0x23);

  ASSERT_EQ(unit.download(0x605D, 0, 0xFFFF, 2), 0U);

  unit.passes(4 * Device::kCycle);
  EXPECT_EQ(unit.statusword() & kState, 0x27);
}

}  // namespace
}  // namespace device
