#include "drive/parameter/bico_text.hpp"

#include <gtest/gtest.h>

namespace drive {
namespace {

constexpr auto kBit = DataType::BinectorInput;
constexpr auto kWord = DataType::ConnectorInput;

TEST(BicoText, IsReadAsItIsPrinted) {
  for (const BicoSource source : {BicoSource{8890, kOwnObject, 0}, BicoSource{52, 3, 15}, BicoSource{8860, 1, 7},
                                  BicoSource{65535, 62, 1023}})
    for (const DataType input : {kBit, kWord})
      EXPECT_EQ(parse_bico(bico_text(source, input, 2), input), pack(source)) << bico_text(source, input, 2);
}

TEST(BicoText, NamesTheDriveObjectOnlyIfItIsAnother) {
  EXPECT_EQ(bico_text({899, 3, 2}, kBit, 2), "r0899.2 of drive object 3");
  EXPECT_EQ(bico_text({899, 3, 2}, kBit, 3), "r0899.2");
  EXPECT_EQ(bico_text({8860, kOwnObject, 1}, kWord, 3), "r8860[1]");
}

TEST(BicoText, TakesAnAxisForItsDriveObjectAndTheFirstPlaceWhereNoneIsNamed) {
  EXPECT_EQ(parse_bico("r0899.2 of axis 2", kBit), pack({899, 3, 2}));
  EXPECT_EQ(parse_bico("r63", kWord), pack({63, kOwnObject, 0}));
  EXPECT_EQ(parse_bico("p2900[0]", kWord), pack({2900, kOwnObject, 0}));
  EXPECT_EQ(parse_bico("0", kWord), 0U);
  EXPECT_EQ(parse_bico("1", kBit), 1U);
}

TEST(BicoText, TakesNothingElse) {
  for (const char* const text : {"",
                                 "2",
                                 "-1",
                                 "r",
                                 "r.0",
                                 "8890.0",
                                 "R8890.0",
                                 "r0.0",
                                 "r65536.0",
                                 "r8890.1024",
                                 "r8890.",
                                 "r8890.-1",
                                 "r8890.0 ",
                                 " r8890.0",
                                 "r8890.0x",
                                 "r8890[0]",
                                 "r8890.0 of",
                                 "r8890.0 of axis 0",
                                 "r8890.0 of axis 9",
                                 "r8890.0 of drive object 63",
                                 "r8890.0 of axis 1 2"})
    EXPECT_FALSE(parse_bico(text, kBit)) << text;
  for (const char* const text : {"r8860.1", "r8860[", "r8860[1", "r8860[]", "r8860[1]]", "r8860[1024]"})
    EXPECT_FALSE(parse_bico(text, kWord)) << text;
}

}  // namespace
}  // namespace drive
