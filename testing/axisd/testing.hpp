#pragma once

/// A simulated drive unit in tests of C++ (docs/how-to/fixtures.md): axisd::testing::Unit. It needs the programs
/// axisd and canhub in PATH, or in $AXISD_BIN_DIR, and nlohmann-json.
///
/// With GoogleTest: a test that has failed shows the last frames and the state of each unit that ends in it.

#include "axisd/testing/unit.hpp"

#if __has_include(<gtest/gtest.h>)

#include <iostream>

#include <gtest/gtest.h>

namespace axisd::testing {

/// Writes the report of @p unit if the test that runs has failed.
inline void report_failure(Unit& unit) {
  if (::testing::Test::HasFailure()) std::cout << "[   axisd  ] " << unit.report() << std::flush;
}

/// Has it done at the end of each unit.
inline const bool kReportsFailures = [] {
  Unit::at_end = report_failure;
  return true;
}();

/// A test with a unit of one axis: class MyTest : public axisd::testing::DriveTest.
class DriveTest : public ::testing::Test {
 protected:
  DriveTest() = default;
  explicit DriveTest(Settings settings) : drive{std::move(settings)} {}

  Unit drive;  // NOLINT(readability-identifier-naming): tests speak of it
};

}  // namespace axisd::testing

#endif
