#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drive/axis/axis.hpp"

namespace drive {

/// How far the measurements of the motor have come.
enum class IdentificationPhase : std::uint8_t {
  Idle,       ///< nothing is selected, nothing was found
  Waiting,    ///< one is selected: for ON, or for the holding brake and standstill after that
  Measuring,  ///< one runs
  Done,       ///< nothing is selected, and there are results since power-on
  Failed,     ///< F07990 or F07985 is active
};

/// "idle", "waiting", ...
std::string_view name_of(IdentificationPhase phase) noexcept;

/// A number that a measurement has found.
struct IdentifiedValue {
  const ParameterRow* row = nullptr;   ///< the parameter that shows it, r1912 to r1984
  double value = 0.0;                  ///< in its unit
  std::optional<double> data_sheet{};  ///< what the data of the configured motor are for it; none: they do not say
  std::optional<double> deviation() const noexcept;  ///< of the value from the data sheet (%)
};

/// The measurements of a motor as a person looks at them.
struct IdentificationView {
  std::string selected;  ///< "none", "standstill (p1910)", "rotating (p1960)", or both
  IdentificationPhase phase = IdentificationPhase::Idle;
  double progress = 0.0;  ///< of the measurement that runs (%), by its steps
  std::string text;       ///< r0047 in words, or what comes next
  std::vector<IdentifiedValue> results{};
};

/// What p1900, p1910 and p1960 of @p axis have selected, do and have found. For people: it allocates.
IdentificationView identification_of(const Axis& axis);

}  // namespace drive
