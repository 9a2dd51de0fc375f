#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace control {

/// What kind of thing went wrong with a request.
enum class ErrorCode : std::uint8_t {
  Malformed,
  UnknownMethod,
  UnknownUnit,
  BadParameter,
  NotFound,
  OutOfRange,
  ReadOnly,
  Refused,
  Off,
  Busy,
  Overflow,
  Unreachable,
};

/// The `code` of an error on the control socket.
struct ErrorName {
  ErrorCode code;
  std::string_view name;
  std::string_view meaning;  ///< for docs/reference/control.md
};
/// In the order of the enumeration.
inline constexpr std::array kErrorNames{
    ErrorName{ErrorCode::Malformed, "malformed", "the line is no request"},
    ErrorName{ErrorCode::UnknownMethod, "unknown-method", "there is no such method"},
    ErrorName{ErrorCode::UnknownUnit, "unknown-unit", "no unit is meant, or several"},
    ErrorName{ErrorCode::BadParameter, "bad-parameter",
              "a parameter of the method is missing or none of its values"},
    ErrorName{ErrorCode::NotFound, "not-found", "no such parameter, object, index, signal, fault, file"},
    ErrorName{ErrorCode::OutOfRange, "out-of-range", "`limits` says what holds"},
    ErrorName{ErrorCode::ReadOnly, "read-only", "never to be written, or not in this state of the unit"},
    ErrorName{ErrorCode::Refused, "refused", "by the unit in its present state, for the reason in the message"},
    ErrorName{ErrorCode::Off, "off", "the unit is switched off"},
    ErrorName{ErrorCode::Busy, "busy", "something that is under way has to end first"},
    ErrorName{ErrorCode::Overflow, "overflow", "too many, or too long"},
    ErrorName{ErrorCode::Unreachable, "unreachable",
              "of a farm: its server, the host of the unit or the unit does not answer"},
};
static_assert(std::ranges::is_sorted(kErrorNames, {}, &ErrorName::code));

[[nodiscard]] constexpr std::string_view name_of(ErrorCode code) noexcept {
  return kErrorNames[static_cast<std::size_t>(code)].name;
}
/// The code called @p name, if there is one.
[[nodiscard]] constexpr std::optional<ErrorCode> error_code_of(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kErrorNames, name, &ErrorName::name);
  return row == kErrorNames.end() ? std::nullopt : std::optional{row->code};
}

/// Why a request was not carried out.
struct Error {
  ErrorCode code;
  std::string message;       ///< one line: what was wrong, and what was expected
  nlohmann::json details{};  ///< further members of the error: `limits`, `abort_code`, ...; null: none
};

}  // namespace control
