#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/farm/agent/plan/told_farm.hpp"

namespace told {

inline const UnitName kUnit{"line1", "5"};

/// The unit of this number, 100 on a bus.
inline UnitName unit(int number) {
  return {"line" + std::to_string(1 + number / 100), std::to_string(1 + number % 100)};
}

/// The document of a unit that may be on @p host alone.
inline std::string at(const std::string& host) {
  return R"({"configuration":{},"host":")" + host + "\"}";
}

/// A farm to which nothing happens that never should.
class PlanTest : public testing::Test {
 protected:
  void TearDown() override { EXPECT_EQ(farm.faults, std::vector<std::string>{}); }

  void want_many(int count) {
    for (int i = 0; i < count; ++i) farm.want(unit(i));
  }
  bool all_run(int count) {
    for (int i = 0; i < count; ++i)
      if (!farm.runs_once(unit(i))) return false;
    return true;
  }
  static std::size_t told(const Host& host, const std::string& part) {
    return static_cast<std::size_t>(std::ranges::count_if(
        host.notices, [&](const std::string& line) { return line.find(part) != std::string::npos; }));
  }

  Farm farm;
};

}  // namespace told
