#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/error.hpp"

namespace axisctl {

/// What the program ends with: one status a cause.
enum class ExitStatus : std::uint8_t {
  Done = 0,
  Failed = 1,
  Usage = 2,
  Refused = 3,
  NotThere = 4,
  NotReachable = 5,
  TimedOut = 6,
  CutOff = 7,
  Off = 8,
  Busy = 9,
  NotUnderstood = 10,
  NotFulfilled = 11,
  Damaged = 12,
};

/// A row of the help, and of the table in docs/reference/exit-statuses.md.
struct ExitRow {
  ExitStatus status;
  std::string_view meaning;
};
inline constexpr std::array kExitRows{
    ExitRow{ExitStatus::Done, "done"},
    ExitRow{ExitStatus::Failed,
            "failed otherwise: a file or standard output cannot be written; compare, replay, twin: there are "
            "differences"},
    ExitRow{ExitStatus::Usage, "wrong usage: words, options, or they fit several units"},
    ExitRow{ExitStatus::Refused, "the unit refuses in its present state, or the value is read-only"},
    ExitRow{ExitStatus::NotThere, "no such axis, parameter, object, signal or file, or a value out of range"},
    ExitRow{ExitStatus::NotReachable, "no daemon or no unit answers"},
    ExitRow{ExitStatus::TimedOut, "no answer within 10 s, or the limit of wait has passed"},
    ExitRow{ExitStatus::CutOff, "the daemon closed the connection"},
    ExitRow{ExitStatus::Off, "the unit is switched off"},
    ExitRow{ExitStatus::Busy, "something that is under way has to end first, or it is too much"},
    ExitRow{ExitStatus::NotUnderstood, "daemon and axisctl do not understand each other, as of another version"},
    ExitRow{ExitStatus::NotFulfilled, "run: a scenario has not gone as it says"},
    ExitRow{ExitStatus::Damaged, "compare, replay, twin: a log is damaged, or has no frame that is meant"},
};

/// The status for an error of the daemon.
struct CodeRow {
  control::ErrorCode code;
  ExitStatus status;
};
/// In the order of control::ErrorCode.
inline constexpr std::array kCodeRows{
    CodeRow{control::ErrorCode::Malformed, ExitStatus::NotUnderstood},
    CodeRow{control::ErrorCode::UnknownMethod, ExitStatus::NotUnderstood},
    CodeRow{control::ErrorCode::UnknownUnit, ExitStatus::Usage},
    CodeRow{control::ErrorCode::BadParameter, ExitStatus::NotThere},
    CodeRow{control::ErrorCode::NotFound, ExitStatus::NotThere},
    CodeRow{control::ErrorCode::OutOfRange, ExitStatus::NotThere},
    CodeRow{control::ErrorCode::ReadOnly, ExitStatus::Refused},
    CodeRow{control::ErrorCode::Refused, ExitStatus::Refused},
    CodeRow{control::ErrorCode::Off, ExitStatus::Off},
    CodeRow{control::ErrorCode::Busy, ExitStatus::Busy},
    CodeRow{control::ErrorCode::Overflow, ExitStatus::Busy},
    CodeRow{control::ErrorCode::Unreachable, ExitStatus::NotReachable},
};
static_assert(kCodeRows.size() == control::kErrorNames.size() &&
              std::ranges::is_sorted(kCodeRows, {}, &CodeRow::code));

[[nodiscard]] constexpr ExitStatus status_of(control::ErrorCode code) noexcept {
  return kCodeRows[static_cast<std::size_t>(code)].status;
}

/// Why something was not done.
struct Failure {
  ExitStatus status = ExitStatus::Failed;
  std::string message{};                              ///< one line
  std::vector<std::string> choices{};                 ///< what there is to choose from, a line each
  nlohmann::json details = nlohmann::json::object();  ///< `code` and whatever else the daemon has told
};

template <class Result>
using Expected = tl::expected<Result, Failure>;

/// A failure as a value.
inline tl::unexpected<Failure> fail(ExitStatus status, std::string message) {
  return tl::unexpected{Failure{.status = status, .message = std::move(message)}};
}

}  // namespace axisctl
