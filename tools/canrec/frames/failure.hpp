#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace canrec {

/// How canrec ends; docs/reference/exit-statuses.md and --help say what each means.
enum class Status : std::uint8_t {
  Done = 0,
  Failed = 1,    ///< a file or standard output
  Usage = 2,     ///< wrong command line
  NoServer = 3,  ///< it is not there, does not answer or refuses
  NotThere = 4,  ///< no such bus or recording, or there is one of that name already
  Damaged = 5,   ///< a line of a log
  NoBus = 6,     ///< the bus to play onto is not there, or takes nothing
  BusDown = 7,   ///< it went down meanwhile
};

/// What went wrong, in one line.
struct Failure {
  Status status = Status::Failed;
  std::string text;
};

template <class T>
using Expected = tl::expected<T, Failure>;

[[nodiscard]] inline tl::unexpected<Failure> fail(Status status, std::string text) {
  return tl::unexpected{Failure{status, std::move(text)}};
}

}  // namespace canrec
