#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

namespace control {

/// What kind of thing went wrong with a request: the `code` of an error on the control socket, and the exit status
/// of axisctl.
enum class ErrorCode : std::uint8_t {
  Malformed,      ///< `malformed`: the line is no request
  UnknownMethod,  ///< `unknown-method`
  UnknownUnit,    ///< `unknown-unit`: no unit, or several, are meant
  BadParameter,   ///< `bad-parameter`: a parameter of the method is missing or none of its values
  NotFound,       ///< `not-found`: no such parameter, object, index, signal, fault, file
  OutOfRange,     ///< `out-of-range`: `limits` says what holds
  ReadOnly,       ///< `read-only`: never, or not in this state of the unit
  Refused,        ///< `refused`: by the unit in its present state, for the reason in the message
  Off,            ///< `off`: the unit is switched off
  Busy,           ///< `busy`: something that is under way has to end first
  Overflow,       ///< `overflow`: too many, or too long
};

/// Why a request was not carried out.
struct Error {
  ErrorCode code;
  std::string message;       ///< one line: what was wrong, and what was expected
  nlohmann::json details{};  ///< further members of the error: `limits`, `abort_code`, ...; null: none
};

}  // namespace control
