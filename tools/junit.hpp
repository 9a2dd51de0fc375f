#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace junit {

/// A test and what came of it.
struct Case {
  enum class Outcome : std::uint8_t { Passed, Failed, Error, Skipped };
  std::string class_name, name;
  double seconds = 0.0;
  Outcome outcome = Outcome::Passed;
  std::string message{};  ///< of a test that has not passed: why, in one line
  std::string type{};     ///< of a failure or error
  std::string text{};     ///< of a failure
  std::string output{};   ///< whatever else there is to say
};

/// Tests that belong together.
struct Suite {
  std::string name;
  std::vector<std::pair<std::string, std::string>> properties{};
  std::vector<Case> cases{};
};

/// The report of @p tool as JUnit XML.
[[nodiscard]] std::string xml_of(std::string_view tool, const std::vector<Suite>& suites);

}  // namespace junit
