#pragma once

#include <string>

#include "drive/parameter/row.hpp"

namespace drive {

/// @p value as an integer if it is one, large ones in hexadecimal.
std::string number_text(double value);

/// What the home of @p row means: "true value", "stored only; would act with ...", "bus"; nothing of a setting
/// that acts.
std::string role_text(const ParameterRow& row);

/// What parameter @p row does in the simulation: its role and its effect.
std::string effect_text(const ParameterRow& row);

}  // namespace drive
