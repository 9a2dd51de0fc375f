#include "tools/axisctl/scenario/language/frame_pattern.hpp"

#include <gtest/gtest.h>

#include "meaning/words.hpp"

namespace scenario {
namespace {

canopen::Frame frame(const char* text) {
  return parse_frame(text).value();
}

struct Fit {
  const char* pattern;
  const char* frame;
  bool fits;
};

class FramePatterns : public testing::TestWithParam<Fit> {};

TEST_P(FramePatterns, FitOrNot) {
  const Fit& fit = GetParam();
  EXPECT_EQ(parse_pattern(fit.pattern).value().fits(frame(fit.frame)), fit.fits)
      << fit.pattern << ' ' << fit.frame;
}

INSTANTIATE_TEST_SUITE_P(
    All, FramePatterns,
    testing::Values(Fit{"185", "185#3716", true}, Fit{"185", "185#", true}, Fit{"185", "185#R", true},
                    Fit{"185", "186#3716", false}, Fit{"185", "00000185#3716", false},
                    Fit{"00000185", "00000185#", true}, Fit{"18x", "18F#", true}, Fit{"18x", "19F#", false},
                    Fit{"xxx", "7FF#00", true}, Fit{"185#3716", "185#3716", true},
                    Fit{"185#3716", "185#371600", false}, Fit{"185#3716", "185#37", false},
                    Fit{"185#3716", "185#3717", false}, Fit{"185#37xx", "185#37FF", true},
                    Fit{"185#3x16", "185#3716", true}, Fit{"185#3x16", "185#4716", false},
                    Fit{"585#80*", "585#8040600002000006", true}, Fit{"585#80*", "585#80", true},
                    Fit{"585#80*", "585#", false}, Fit{"585#*", "585#", true}, Fit{"185#", "185#00", false},
                    Fit{"705#R", "705#R", true}, Fit{"705#R", "705#R1", true}, Fit{"705#R1", "705#R", false},
                    Fit{"705#R", "705#7F", false}, Fit{"705#7F", "705#R1", false}));

TEST(ServiceOfAFrame, IsThatOfThePredefinedConnectionSet) {
  EXPECT_EQ(meaning::service_of(frame("000#0105")), "NMT start");
  EXPECT_EQ(meaning::service_of(frame("080#")), "SYNC");
  EXPECT_EQ(meaning::service_of(frame("085#0000000000000000")), "EMCY");
  EXPECT_EQ(meaning::service_of(frame("100#")), "TIME");
  EXPECT_EQ(meaning::service_of(frame("185#3716")), "TPDO1");
  EXPECT_EQ(meaning::service_of(frame("505#00")), "RPDO4");
  EXPECT_EQ(meaning::service_of(frame("605#4000100000000000")), "SDO request");
  EXPECT_EQ(meaning::service_of(frame("585#8000100000000208")), "SDO abort");
  EXPECT_EQ(meaning::service_of(frame("705#00")), "boot-up");
  EXPECT_EQ(meaning::service_of(frame("705#05")), "heartbeat Operational");
  EXPECT_EQ(meaning::service_of(frame("705#R1")), "node guarding");
  EXPECT_EQ(meaning::service_of(frame("00000705#00")), "");
}

}  // namespace
}  // namespace scenario
