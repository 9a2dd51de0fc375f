#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "record/format.hpp"

namespace axisd {

/// What is to be recorded of a unit, as key "record" and method record.start say it.
struct RecordSettings {
  /// The least and the most of a number.
  struct Limits {
    double low;
    double high;
  };
  static constexpr Limits kSize{1, 1024};        ///< MB
  static constexpr Limits kPeriod{0.001, 3600};  ///< s
  static constexpr Limits kBefore{0, 60};        ///< s
  static constexpr Limits kAfter{0, 600};        ///< s
  static constexpr std::size_t kMostSignals = record::kMostSignals;

  std::string name{};                  ///< empty: date and time of the beginning
  double most_MB = 100;                ///< of all its files together
  std::vector<std::string> signals{};  ///< whose values are recorded
  std::optional<double> period{};      ///< of the values (s); none: the process-data cycle
  bool on_fault = false;               ///< only what is around faults
  double before = 10;                  ///< a fault (s)
  double after = 5;                    ///< a fault (s)
};

}  // namespace axisd
