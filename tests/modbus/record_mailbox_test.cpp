#include "modbus/record_mailbox.hpp"

#include <gtest/gtest.h>

#include "tests/modbus/hexadecimal.hpp"

namespace modbus {
namespace {

using Words = std::vector<std::uint16_t>;

struct Mailbox : testing::Test {
  Words read(std::size_t count = 5) const {
    Words words;
    for (std::size_t i = 0; i < count; ++i) words.push_back(mailbox.read(i));
    return words;
  }
  void write(std::size_t first, const Words& words) { mailbox.write(first, words); }

  RecordMailbox mailbox;
};

TEST_F(Mailbox, HoldsWhatIsWrittenUntilItIsActivated) {
  write(1, {0x2F04, 0x1122, 0x3344});
  EXPECT_EQ(read(), (Words{0, 0x2F04, 0x1122, 0x3344, 0}));
  EXPECT_FALSE(mailbox.is_pending());
}

TEST_F(Mailbox, TakesARequestAtOnceOrRegisterByRegister) {
  write(0, {1, 0x2F03, 0x1122, 0x3344});
  EXPECT_TRUE(mailbox.is_pending());
  EXPECT_EQ(hexadecimal(mailbox.request()), "112233");

  RecordMailbox other;
  const Words words{1, 0x2F03, 0x1122, 0x3344};
  for (const std::size_t place : {3U, 2U, 1U, 0U}) other.write(place, std::span{words}.subspan(place, 1));
  EXPECT_EQ(hexadecimal(other.request()), "112233");
}

TEST_F(Mailbox, IsNotReadyUntilTheAnswerIsThere) {
  write(0, {1, 0x2F04, 0x1122, 0x3344, 0x5566});
  EXPECT_EQ(read(), (Words{1, 0x2F00, 4, 0, 0}));

  mailbox.finish(bytes_of("AABBCC"));

  EXPECT_EQ(read(), (Words{2, 0x2F03, 0xAABB, 0xCC00, 0}));
  EXPECT_FALSE(mailbox.is_pending());
}

TEST_F(Mailbox, RefusesOtherFunctions) {
  write(0, {1, 0x3004, 0x1122});
  EXPECT_EQ(read(), (Words{2, 0x2F00, 3, 0, 0}));
  EXPECT_FALSE(mailbox.is_pending());
}

TEST_F(Mailbox, RefusesLengthsWithoutARecord) {
  for (const std::uint16_t head : Words{0x2F00, 0x2FF1, 0x2FFF}) {
    write(0, {1, head, 0x1122});
    EXPECT_EQ(read(), (Words{2, 0x2F00, 1, 0, 0}));
  }
  write(0, {1, 0x2FF0});
  EXPECT_EQ(mailbox.request().size(), 240U);
}

TEST_F(Mailbox, RefusesAnotherRequestWhileOneRuns) {
  write(0, {1, 0x2F02, 0x1111});
  write(0, {1, 0x2F02, 0x2222});

  EXPECT_EQ(read(), (Words{2, 0x2F00, 2, 0, 0}));
  EXPECT_EQ(hexadecimal(mailbox.request()), "1111");

  mailbox.finish(bytes_of("AABB"));
  EXPECT_EQ(read(), (Words{2, 0x2F02, 0xAABB, 0, 0}));
}

TEST_F(Mailbox, SaysWhenTheRequestCouldNotBeCarriedOut) {
  write(0, {1, 0x2F02, 0x1111});
  mailbox.finish({});
  EXPECT_EQ(read(), (Words{2, 0x2F00, 5, 0, 0}));
}

TEST_F(Mailbox, HasNothingBehindItsEnd) {
  write(120, {7, 8, 9, 10});
  EXPECT_EQ(mailbox.read(120), 7);
  EXPECT_EQ(mailbox.read(121), 8);
}

}  // namespace
}  // namespace modbus
