#include "can/hub/filter/filter_set.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/error.h>

namespace hub {
namespace {

constexpr canid_t kStandardOnly = CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_SFF_MASK;
constexpr canid_t kExtendedOnly = CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_EFF_MASK;
constexpr canid_t kErrorFrame = CAN_ERR_FLAG | CAN_ERR_BUSOFF;

/// What the kernel does with a frame and a list of filters (linux/can.h, net/can/af_can.c).
struct Case {
  const char* name;
  std::vector<can_filter> filters;
  std::vector<canid_t> passed;
  std::vector<canid_t> stopped;
  bool joined = false;
  std::uint32_t error_mask = 0;
};

void PrintTo(const Case& row, std::ostream* out) {
  *out << row.name;
}

const std::vector<Case> kCases{
    {"NoFilter", {}, {}, {0x123, 0x123 | CAN_EFF_FLAG, kErrorFrame}},
    {"MaskZeroPassesAllButErrorFrames",
     {{0x123, 0}},
     {0, 0x7FF, 0x123 | CAN_RTR_FLAG, CAN_EFF_FLAG | CAN_EFF_MASK},
     {kErrorFrame}},
    {"MaskOfTheIdentifierTakesBothFormats",
     {{0x123, CAN_SFF_MASK}},
     {0x123, 0x123 | CAN_RTR_FLAG, 0x123 | CAN_EFF_FLAG, 0x923 | CAN_EFF_FLAG},
     {0x122, 0x124 | CAN_EFF_FLAG}},
    {"OneStandardIdentifier",
     {{0x123, kStandardOnly}},
     {0x123},
     {0x122, 0x123 | CAN_RTR_FLAG, 0x123 | CAN_EFF_FLAG}},
    {"OneExtendedIdentifier",
     {{0x123 | CAN_EFF_FLAG, kExtendedOnly}},
     {0x123 | CAN_EFF_FLAG},
     {0x123, 0x124 | CAN_EFF_FLAG, 0x123 | CAN_EFF_FLAG | CAN_RTR_FLAG}},
    {"StandardIdentifierUnderAMaskOf29Bits", {{0x123, kExtendedOnly}}, {0x123}, {0x124, 0x123 | CAN_EFF_FLAG}},
    {"IdentifierBitsOutsideTheMaskDoNotCount", {{0x7FF, 0x700}}, {0x700, 0x7AB}, {0x600, 0x123}},
    {"RemoteFramesOnly", {{CAN_RTR_FLAG, CAN_RTR_FLAG}}, {0x123 | CAN_RTR_FLAG}, {0x123}},
    {"Inverted",
     {{0x123 | CAN_INV_FILTER, CAN_SFF_MASK}},
     {0x122, 0x7FF, 0x124 | CAN_EFF_FLAG},
     {0x123, 0x123 | CAN_EFF_FLAG, kErrorFrame}},
    {"InvertedWithoutMaskPassesNothing", {{CAN_INV_FILTER, 0}}, {}, {0, 0x123, CAN_EFF_FLAG}},
    {"AnyOfSeveral", {{0x100, 0x7FF}, {0x200, 0x7FF}}, {0x100, 0x200}, {0x300}},
    {"SeveralInvertedAreLeftByAnyOfThem",
     {{0x100 | CAN_INV_FILTER, 0x7FF}, {0x200 | CAN_INV_FILTER, 0x7FF}},
     {0x100, 0x200, 0x300},
     {}},
    {"SeveralInvertedJoined",
     {{0x100 | CAN_INV_FILTER, 0x7FF}, {0x200 | CAN_INV_FILTER, 0x7FF}},
     {0x300},
     {0x100, 0x200},
     true},
    {"JoinedAllMustMatch", {{0x100, 0x700}, {0x001, 0x001}}, {0x101, 0x1FF}, {0x100, 0x001}, true},
    {"JoinedOne", {{0x100, 0x7FF}}, {0x100}, {0x101}, true},
    {"JoinedNone", {}, {}, {0x100}, true},
    {"ErrorMask",
     {{0, 0}},
     {kErrorFrame, 0x123},
     {CAN_ERR_FLAG | CAN_ERR_CRTL, CAN_ERR_FLAG},
     false,
     CAN_ERR_BUSOFF},
    {"ErrorMaskWithoutFilters", {}, {kErrorFrame}, {0x123, CAN_ERR_BUSOFF}, false, CAN_ERR_MASK},
    {"ErrorMaskJoinedWithTwoFilters", {{0, 0}, {0, 0}}, {0x123}, {kErrorFrame}, true, CAN_ERR_MASK},
    {"ErrorMaskJoinedWithOneFilter", {{0, 0}}, {0x123, kErrorFrame}, {}, true, CAN_ERR_MASK},
    {"FilterForErrorFrames",
     {{0, CAN_ERR_FLAG | CAN_ERR_BUSOFF}},
     {kErrorFrame},
     {0x123, 0, CAN_ERR_FLAG | CAN_ERR_CRTL}},
};

class FilterSetCases : public testing::TestWithParam<Case> {};

TEST_P(FilterSetCases, ActsAsTheKernelDoes) {
  const Case& row = GetParam();
  FilterSet set;
  set.assign(row.filters);
  set.set_joined(row.joined);
  set.set_error_mask(row.error_mask);

  for (const canid_t id : row.passed) EXPECT_TRUE(set.passes(id)) << std::hex << id;
  for (const canid_t id : row.stopped) EXPECT_FALSE(set.passes(id)) << std::hex << id;
}

INSTANTIATE_TEST_SUITE_P(Kernel, FilterSetCases, testing::ValuesIn(kCases),
                         [](const auto& row) { return std::string{row.param.name}; });

TEST(FilterSet, LetsAllFramesPassAtFirst) {
  const FilterSet set;

  EXPECT_TRUE(set.passes(0x123));
  EXPECT_TRUE(set.passes(CAN_EFF_FLAG | 0x12345678));
  EXPECT_FALSE(set.passes(kErrorFrame));
  ASSERT_EQ(set.filters().size(), 1u);
  EXPECT_EQ(set.filters()[0].can_mask, 0u);
}

TEST(FilterSet, GivesBackWhatItWasGiven) {
  FilterSet set;
  set.assign(std::vector<can_filter>{{0x123 | CAN_INV_FILTER, kExtendedOnly}});

  ASSERT_EQ(set.filters().size(), 1u);
  EXPECT_EQ(set.filters()[0].can_id, 0x123 | CAN_INV_FILTER);
  EXPECT_EQ(set.filters()[0].can_mask, kExtendedOnly);
}

}  // namespace
}  // namespace hub
