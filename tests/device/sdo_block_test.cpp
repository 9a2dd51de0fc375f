#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::string_view kInitiateBlockUpload = "605#A408100010000000";  // 1008h, CRC, 16 segments a block

TEST(SdoBlock, IsRefusedAsByTheRealUnit) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.says(kInitiateBlockUpload), Lines{"585#8008100001000405"});
}

TEST(SdoBlock, WorksWhereTheConfigurationAllowsIt) {
  Configuration configuration = unit_with({});
  configuration.sdo_block = true;
  TestUnit unit{configuration};
  unit.start();

  EXPECT_EQ(unit.says(kInitiateBlockUpload), Lines{"585#C608100008000000"});
  EXPECT_EQ(unit.says("605#A300000000000000"), (Lines{"585#0153494E414D4943", "585#8253000000000000"}));
}

}  // namespace
}  // namespace device
