#pragma once

#include <string>

#include "tools/axisctl/commands/command.hpp"

namespace axisctl {

/// A comparison with a number.
struct Comparison {
  bool (*compare)(double left, double right);
  double right = 0.0;

  bool holds(double left) const { return compare(left, right); }
};

/// @p word (lt, le, eq, ne, ge, gt, or their signs) with @p number.
[[nodiscard]] Expected<Comparison> parse_comparison(const std::string& word, const std::string& number);

/// The value of @p signal now.
[[nodiscard]] Expected<double> read_signal(Session& session, const std::string& signal);

}  // namespace axisctl
