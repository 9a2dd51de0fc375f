#pragma once

#include <nlohmann/json.hpp>

#include "daemon/control/arguments.hpp"
#include "daemon/control/parameters/parameter_name.hpp"

namespace axisd {

/// @p value of @p row, a parameter of @p object, as the control socket shows it: a number, of a BICO input its
/// source as a text ("r0899.2", "0").
nlohmann::json value_json(const drive::ParameterRow& row, const drive::ParameterValue& value,
                          const drive::DriveObject& object);

/// The number that @p value is for @p target, of a bit that of the whole parameter: a number, true or false, or a
/// text: decimal, hexadecimal (0x1F, 1Fh), binary (0b101), the source of a BICO input. BadParameter if it is none;
/// neither limits nor state are looked at.
Taken<double> number_of(const drive::DriveUnit& unit, const ParameterTarget& target, const nlohmann::json& value);

/// Limits of @p row with its unit; null if they are those of a floating-point type.
nlohmann::json limits_json(const drive::ParameterRow& row);

/// @p error of @p target as the control socket tells it, with what has to be different in the details.
control::Error refusal_of(const drive::ParameterError& error, const ParameterTarget& target, bool is_saving);

}  // namespace axisd
