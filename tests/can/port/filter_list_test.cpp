#include "can/port/filter_list.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/fakes/candump.hpp"

namespace bus {
namespace {

TEST(FilterList, LetsEverythingPassAtFirst) {
  const FilterList filters;

  EXPECT_TRUE(filters.pass(fakes::frame_of("605#")));
  EXPECT_TRUE(filters.pass(fakes::frame_of("1FFFFFFF#R")));
}

TEST(FilterList, LetsPassExactlyWhatItNames) {
  FilterList filters;
  filters.assign(std::vector{Filter{.identifier = 0x605}, Filter{.identifier = 0x705, .remote = true},
                             Filter{.identifier = 0x80, .extended = true}});

  for (const char* const wanted : {"605#01", "705#R", "00000080#"})
    EXPECT_TRUE(filters.pass(fakes::frame_of(wanted))) << wanted;
  for (const char* const other : {"604#01", "605#R", "705#00", "00000605#", "080#"})
    EXPECT_FALSE(filters.pass(fakes::frame_of(other))) << other;
}

TEST(FilterList, LetsNothingPassWithoutAFilter) {
  FilterList filters;
  filters.assign({});

  EXPECT_FALSE(filters.pass(fakes::frame_of("000#")));
}

TEST(FilterList, LetsEverythingPassIfThereAreTooMany) {
  FilterList filters;
  filters.assign(std::vector<Filter>(CAN_RAW_FILTER_MAX + 1, Filter{.identifier = 1}));

  EXPECT_TRUE(filters.pass(fakes::frame_of("605#01")));
}

}  // namespace
}  // namespace bus
