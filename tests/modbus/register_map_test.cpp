#include "modbus/register_map.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "modbus/register_bank.hpp"

namespace modbus {
namespace {

TEST(RegisterMap, FindsRowsByTheirEnds) {
  for (const RegisterRow& row : register_map()) {
    EXPECT_EQ(find_register(row.first), &row);
    EXPECT_EQ(find_register(row.last), &row);
  }
}

TEST(RegisterMap, HasNothingElse) {
  int in_rows = 0, found = 0;
  for (const RegisterRow& row : register_map()) in_rows += row.last - row.first + 1;
  for (unsigned number = 0; number <= 0xFFFF; ++number)
    if (find_register(static_cast<std::uint16_t>(number)) != nullptr) ++found;
  EXPECT_EQ(found, in_rows);
  for (const unsigned reserved : {40001U, 40099U, 40120U, 40302U, 40346U, 40348U, 40410U, 40600U, 40723U})
    EXPECT_EQ(find_register(static_cast<std::uint16_t>(reserved)), nullptr) << reserved;
}

TEST(RegisterMap, RoundsHalfAwayFromZero) {
  EXPECT_EQ(shown({}, 2.5), 3);
  EXPECT_EQ(shown({}, 2.4), 2);
  EXPECT_EQ(shown({.multiplier = 100}, 0.125), 13);
  EXPECT_EQ(shown({.is_signed = true}, -2.5), 0xFFFD);
}

TEST(RegisterMap, CutsQuotientsOff) {
  EXPECT_EQ(shown({.divisor = 10000}, 4806500), 480);
  EXPECT_EQ(shown({.divisor = 10000}, 4809999), 480);
  EXPECT_EQ(shown({.divisor = 10000}, 4810000), 481);
}

TEST(RegisterMap, ShowsTheEndsOfWhatDoesNotFit) {
  EXPECT_EQ(shown({}, 65535.4), 0xFFFF);
  EXPECT_EQ(shown({}, 1e30), 0xFFFF);
  EXPECT_EQ(shown({}, -1), 0);
  EXPECT_EQ(shown({.is_signed = true}, 40000), 0x7FFF);
  EXPECT_EQ(shown({.is_signed = true}, -40000), 0x8000);
  EXPECT_EQ(shown({}, NAN), 0);
}

TEST(RegisterMap, ReadsBackWhatItShows) {
  for (const Scale scale : {Scale{}, Scale{.multiplier = 10}, Scale{.multiplier = 100}, Scale{.multiplier = 1000},
                            Scale{.is_signed = true}, Scale{.multiplier = 100, .is_signed = true}})
    for (unsigned word = 0; word <= 0xFFFF; ++word)
      ASSERT_EQ(shown(scale, value_of(scale, static_cast<std::uint16_t>(word))), word);
}

}  // namespace
}  // namespace modbus
