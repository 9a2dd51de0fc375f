#include "modbus/functions.hpp"

#include <gtest/gtest.h>

#include "tests/modbus/fake_bank.hpp"
#include "tests/modbus/hexadecimal.hpp"

namespace modbus {
namespace {

struct Functions : testing::Test {
  std::string ask(std::string_view request) {
    std::array<std::uint8_t, kMostPduBytes> response{};
    const std::size_t bytes = answer(bytes_of(request), response, bank);
    return hexadecimal(std::span{response}.first(bytes));
  }

  FakeBank bank;
};

TEST_F(Functions, ReadsRegisters) {
  EXPECT_EQ(ask("03 0000 0002"), "030400410042");
  EXPECT_EQ(ask("03 02D1 0001"), "03020012");
  EXPECT_EQ(ask("03 0000 007D").size(), 2 * (2 + 2 * 125));
}

TEST_F(Functions, WritesARegister) {
  EXPECT_EQ(ask("06 0063 5566"), "0600635566");
  EXPECT_EQ(bank.written, (std::map<std::uint16_t, std::uint16_t>{{40100, 0x5566}}));
}

TEST_F(Functions, WritesRegisters) {
  EXPECT_EQ(ask("10 0063 0002 04 0001 FFFE"), "1000630002");
  EXPECT_EQ(bank.written, (std::map<std::uint16_t, std::uint16_t>{{40100, 1}, {40101, 0xFFFE}}));
}

TEST_F(Functions, RefuseWhatTheyDoNotKnow) {
  for (unsigned code = 0; code < 0x80; ++code) {
    if (code == 3 || code == 6 || code == 16) continue;
    const std::array request{static_cast<std::uint8_t>(code)};
    EXPECT_EQ(ask(hexadecimal(request)), hexadecimal(std::array{static_cast<std::uint8_t>(code | 0x80U)}) + "01");
  }
}

TEST_F(Functions, RefuseRegistersThatDoNotExist) {
  EXPECT_EQ(ask("03 02D1 0002"), "8302");
  EXPECT_EQ(ask("03 02D2 0001"), "8302");
  EXPECT_EQ(ask("03 FFFF 007D"), "8302");
  EXPECT_EQ(ask("06 02D2 0000"), "8602");
  EXPECT_EQ(ask("10 02D1 0002 04 0000 0000"), "9002");
  EXPECT_TRUE(bank.written.empty());
}

TEST_F(Functions, RefuseCountsBeforeAddresses) {
  EXPECT_EQ(ask("03 0000 0000"), "8303");
  EXPECT_EQ(ask("03 FFFF 0000"), "8303");
  EXPECT_EQ(ask("03 FFFF 007E"), "8303");
  EXPECT_EQ(ask("03 0000 FFFF"), "8303");
  EXPECT_EQ(ask("10 FFFF 0000 00"), "9003");
  EXPECT_EQ(ask("10 0063 007C F8" + std::string(4 * 124, '0')), "9003");
}

TEST_F(Functions, RefuseLengthsThatDoNotFit) {
  EXPECT_EQ(ask("03"), "8303");
  EXPECT_EQ(ask("03 0000 00"), "8303");
  EXPECT_EQ(ask("03 0000 0001 00"), "8303");
  EXPECT_EQ(ask("06 0000 00"), "8603");
  EXPECT_EQ(ask("06 0000 0000 0000"), "8603");
  EXPECT_EQ(ask("10 0063 0001"), "9003");
  EXPECT_EQ(ask("10 0063 0001 02 00"), "9003");
  EXPECT_EQ(ask("10 0063 0001 02 0000 00"), "9003");
  EXPECT_EQ(ask("10 0063 0001 04 0000 0000"), "9003");
  EXPECT_EQ(ask("10 0063 0002 03 0000 0000"), "9003");
  EXPECT_TRUE(bank.written.empty());
}

TEST_F(Functions, SayWhenAWriteIsRefused) {
  bank.refused = {40100};
  EXPECT_EQ(ask("06 0063 0000"), "8604");
  EXPECT_EQ(ask("10 0063 0001 02 0000"), "9004");
}

}  // namespace
}  // namespace modbus
