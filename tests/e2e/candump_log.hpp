#pragma once

#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

namespace e2e {

/// candump -L on the test interface, and cansend: what a person at a terminal sees and does.
class CandumpLog {
 public:
  /// Starts to record; throws std::runtime_error that says how to get the interface.
  CandumpLog();

  /// Sends @p frame with cansend; what is looked for next stands behind it, unless it is an error frame, which
  /// candump does not record.
  testing::AssertionResult send(const std::string& frame);
  /// Waits until @p frames stand in the record in that order, others between them, behind what was found last.
  testing::AssertionResult shows(std::initializer_list<std::string> frames);
  /// No frame has come under @p identifiers, such as "185", behind what was found last.
  testing::AssertionResult shows_none_of(std::initializer_list<std::string> identifiers);

 private:
  Program candump_;
  std::size_t from_ = 0;
};

}  // namespace e2e
